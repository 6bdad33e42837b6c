#!/usr/bin/env python3
#------------------------------------------------------------------------------
# Draws cuts through cases of Allrun, the fields beside each other: standard,
# the paper's, gradientPower. Needs VTK for Python, and no display.
#
#     verification/pictures.py cases
#
# <name>.field.png       level sets 0.1, 0.2, ... 0.9 between wall and envelope
# <name>.levelSets.png   layers on level sets
# <name>.layers.png      layers at the requested heights
#------------------------------------------------------------------------------
import argparse
import os
import sys
import vtk

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                "../doc/pictures"))
import layers

FIELDS = ("isotropic", "anisotropic", "gradientPower")

# Middle of the picture, its normal and up direction, and its height [m]
VIEWS = {
    "wedge90": ((0, 0.16, 0.508), (0, 0, 1), (0, 1, 0), 0.44),
    "slit": ((0, 0.06, 0.483), (0, 0, 1), (0, 1, 0), 0.30),
    "corner60": ((0, 0.2, 0.508), (0, 0, 1), (0, 1, 0), 0.5),
}


def options(name):
    centre, normal, up, height = VIEWS[name]

    return argparse.Namespace(centre=centre, normal=normal, up=up,
                              height=height)


def beside(images):
    append = vtk.vtkImageAppend()
    for image in images:
        append.AddInputData(image)
    append.Update()

    return append.GetOutput()


def of_layers(case, view):
    cutter = layers.cut(layers.near(layers.read_mesh(case), view), view)
    cutter.Update()

    return layers.paint(list(layers.projected(cutter.GetOutput(), view)))


def of_field(case, view):
    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName(case + "/postProcessing/harmonicPrismMesh/"
                       "backgroundMesh.vtk")
    reader.ReadAllFieldsOn()
    reader.Update()
    mesh = layers.near(reader.GetOutput(), view)
    mesh.GetPointData().SetActiveScalars("H")

    cutter = layers.cut(mesh, view)
    cutter.GenerateTrianglesOn()
    cutter.Update()
    canvas = layers.paint([])

    # The domain, without the edges of its cells
    for polygon in layers.projected(cutter.GetOutput(), view):
        canvas.fill(polygon, b"\xd1\xe5\xf7")

    contour = vtk.vtkContourFilter()
    contour.SetInputConnection(cutter.GetOutputPort())
    for i in range(1, 10):
        contour.SetValue(i - 1, 0.1*i)
    contour.Update()

    for a, b in layers.projected(contour.GetOutput(), view):
        canvas.line(a, b, b"\x19\x37\x64", layers.LINE + 1)

    return canvas


def draw(root, name, ending, kind, of_case):
    folders = [os.path.join(root, name, field + ending) for field in FIELDS]

    if not all(os.path.exists(folder + "/constant/polyMesh")
               for folder in folders):
        return

    view = options(name)
    layers.write(beside([of_case(folder, view).image() for folder in folders]),
                 os.path.join(root, name + "." + kind + ".png"))


def main():
    if len(sys.argv) != 2:
        sys.exit("Usage: verification/pictures.py <folder of cases>")

    layers.PIXELS = (480, 480)
    for name in VIEWS:
        draw(sys.argv[1], name, "", "field", of_field)
        draw(sys.argv[1], name, ".levelSets", "levelSets", of_layers)
        draw(sys.argv[1], name, "", "layers", of_layers)


main()
