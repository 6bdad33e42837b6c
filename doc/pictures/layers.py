#!/usr/bin/env python3
#------------------------------------------------------------------------------
# Draws a plane cut through the layers of a case, to a PNG file. Needs VTK for
# Python (Debian: python3-vtk9), and no display.
#
#     doc/pictures/layers.py -h
#------------------------------------------------------------------------------
import argparse
import math
import os
import sys
import vtk

PIXELS = (900, 600)

# Pixels that are drawn, for a pixel that is written, in each direction
FINENESS = 3

# Width of lines, in pixels that are drawn
LINE = 3


def arguments():
    parser = argparse.ArgumentParser(
        description="Draw a cut through the layers of a case.")
    parser.add_argument("case", help="folder of the case")
    parser.add_argument("picture", help="PNG file to write")
    parser.add_argument("--centre", nargs=3, type=float, required=True,
                        metavar=("X", "Y", "Z"),
                        help="point of the plane in the middle of the picture")
    parser.add_argument("--normal", nargs=3, type=float, default=(0, 0, 1),
                        metavar=("X", "Y", "Z"), help="of the plane")
    parser.add_argument("--up", nargs=3, type=float, default=(0, 1, 0),
                        metavar=("X", "Y", "Z"),
                        help="direction that is up in the picture")
    parser.add_argument("--height", type=float, required=True,
                        help="of what the picture shows [m]")

    return parser.parse_args()


def read_mesh(case):
    """Cells of constant/polyMesh"""
    stub = os.path.join(case, "layers.py.foam")
    open(stub, "w").close()

    try:
        reader = vtk.vtkOpenFOAMReader()
        reader.SetFileName(stub)
        reader.UpdateInformation()
        reader.DisableAllPatchArrays()
        reader.SetPatchArrayStatus("internalMesh", 1)
        reader.DecomposePolyhedraOff()
        reader.Update()
    finally:
        os.remove(stub)

    mesh = reader.GetOutput().GetBlock(0)

    if mesh is None or mesh.GetNumberOfCells() == 0:
        sys.exit("No mesh in " + case)

    return mesh


def near(mesh, options):
    """Cells that the picture can show: the others cost time"""
    reach = options.height*PIXELS[0]/PIXELS[1]
    sphere = vtk.vtkSphere()
    sphere.SetCenter(options.centre)
    sphere.SetRadius(reach)

    extract = vtk.vtkExtractGeometry()
    extract.SetInputData(mesh)
    extract.SetImplicitFunction(sphere)
    extract.ExtractBoundaryCellsOn()
    extract.Update()

    return extract.GetOutput()


def cut(mesh, options):
    plane = vtk.vtkPlane()
    plane.SetOrigin(options.centre)
    plane.SetNormal(options.normal)

    cutter = vtk.vtkCutter()
    cutter.SetInputData(mesh)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOff()

    return cutter


def projected(surface, options):
    """Polygons of the cut in pixels of the canvas, (0, 0) down on the left"""
    normal, up, right = list(options.normal), list(options.up), [0, 0, 0]
    vtk.vtkMath.Normalize(normal)
    vtk.vtkMath.Cross(up, normal, right)
    vtk.vtkMath.Normalize(right)
    vtk.vtkMath.Cross(normal, right, up)

    scale = FINENESS*PIXELS[1]/options.height
    pixels = []

    for i in range(surface.GetNumberOfPoints()):
        r = [x - c for x, c in zip(surface.GetPoint(i), options.centre)]
        pixels.append((0.5*FINENESS*PIXELS[0] + scale*vtk.vtkMath.Dot(r, right),
                       0.5*FINENESS*PIXELS[1] + scale*vtk.vtkMath.Dot(r, up)))

    for i in range(surface.GetNumberOfCells()):
        ids = surface.GetCell(i).GetPointIds()
        yield [pixels[ids.GetId(j)] for j in range(ids.GetNumberOfIds())]


class Canvas:
    def __init__(self):
        self.width, self.height = (FINENESS*n for n in PIXELS)
        self.bytes = bytearray(b"\xff"*(3*self.width*self.height))

    def fill(self, polygon, colour):
        """A convex polygon, row by row"""
        ys = [y for x, y in polygon]
        sides = list(zip(polygon, polygon[1:] + polygon[:1]))

        for row in range(max(0, math.ceil(min(ys))),
                         min(self.height - 1, math.floor(max(ys))) + 1):
            xs = [x0 + (row - y0)/(y1 - y0)*(x1 - x0)
                  for (x0, y0), (x1, y1) in sides
                  if min(y0, y1) <= row <= max(y0, y1) and y0 != y1]
            first = max(0, math.ceil(min(xs))) if xs else 0
            last = min(self.width - 1, math.floor(max(xs))) if xs else -1

            if first <= last:
                start = 3*(row*self.width + first)
                count = last - first + 1
                self.bytes[start:start + 3*count] = colour*count

    def line(self, a, b, colour, width):
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = math.hypot(dx, dy)

        if length > 0:
            u, v = 0.5*width*dy/length, 0.5*width*dx/length
            self.fill([(a[0] - u, a[1] + v), (b[0] - u, b[1] + v),
                       (b[0] + u, b[1] - v), (a[0] + u, a[1] - v)], colour)

    def image(self):
        """Averaged over the pixels of the canvas: lines without steps"""
        source = vtk.vtkImageImport()
        source.CopyImportVoidPointer(bytes(self.bytes), len(self.bytes))
        source.SetDataScalarTypeToUnsignedChar()
        source.SetNumberOfScalarComponents(3)
        extent = (0, self.width - 1, 0, self.height - 1, 0, 0)
        source.SetDataExtent(extent)
        source.SetWholeExtent(extent)

        shrink = vtk.vtkImageShrink3D()
        shrink.SetInputConnection(source.GetOutputPort())
        shrink.SetShrinkFactors(FINENESS, FINENESS, 1)
        shrink.MeanOn()
        shrink.Update()

        return shrink.GetOutput()


def write(image, picture):
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputData(image)
    writer.Write()


def paint(polygons):
    """Cells in a light colour, their edges in a dark one"""
    canvas = Canvas()

    for polygon in polygons:
        canvas.fill(polygon, b"\xd1\xe5\xf7")

    for polygon in polygons:
        for a, b in zip(polygon, polygon[1:] + polygon[:1]):
            canvas.line(a, b, b"\x19\x37\x64", LINE)

    return canvas


def main():
    options = arguments()
    cutter = cut(near(read_mesh(options.case), options), options)
    cutter.Update()
    polygons = list(projected(cutter.GetOutput(), options))

    if not polygons:
        sys.exit("There are no cells in the picture")

    write(paint(polygons).image(), options.picture)


if __name__ == "__main__":
    main()
