#!/usr/bin/env python3
#------------------------------------------------------------------------------
# Draws a field of the wall that harmonicPrismMesh -writeFields has written, to
# a PNG file. Needs VTK for Python (Debian: python3-vtk9) and a display, or
# xvfb-run.
#
#     doc/pictures/wall.py -h
#------------------------------------------------------------------------------
import argparse
import os
import sys
import vtk

PIXELS = (900, 600)


def arguments():
    parser = argparse.ArgumentParser(
        description="Draw a field of the wall of a case.")
    parser.add_argument("case", help="folder of the case")
    parser.add_argument("picture", help="PNG file to write")
    parser.add_argument("--field", default="thicknessOverRequest")
    parser.add_argument("--range", nargs=2, type=float, default=(0, 1),
                        metavar=("FROM", "TO"), help="red to blue")
    parser.add_argument("--view", nargs=3, type=float, default=(1, -1, 0.6),
                        metavar=("X", "Y", "Z"), help="towards the eye")
    parser.add_argument("--up", nargs=3, type=float, default=(0, 0, 1),
                        metavar=("X", "Y", "Z"),
                        help="direction that is up in the picture")

    return parser.parse_args()


def read_wall(options):
    file = os.path.join(options.case,
                        "postProcessing/harmonicPrismMesh/wall.vtk")

    if not os.path.exists(file):
        sys.exit("No " + file + "; run harmonicPrismMesh -writeFields")

    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName(file)
    reader.ReadAllFieldsOn()
    reader.Update()
    wall = reader.GetOutput()

    if not any(data.HasArray(options.field)
               for data in (wall.GetPointData(), wall.GetCellData())):
        sys.exit("No field " + options.field + " in " + file)

    return wall


def coloured(wall, options):
    surface = vtk.vtkGeometryFilter()
    surface.SetInputData(wall)

    colours = vtk.vtkLookupTable()
    colours.SetHueRange(0, 0.6)
    colours.SetTableRange(options.range)
    colours.Build()

    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SelectColorArray(options.field)
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()

    if wall.GetPointData().HasArray(options.field):
        mapper.SetScalarModeToUsePointFieldData()
    else:
        mapper.SetScalarModeToUseCellFieldData()

    actor = vtk.vtkActor()
    actor.SetMapper(mapper)

    return actor, colours


def legend(colours, title):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetTitle(title)
    bar.SetNumberOfLabels(3)
    bar.SetBarRatio(0.2)
    bar.SetPosition(0.8, 0.1)
    bar.SetUnconstrainedFontSize(True)

    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0, 0, 0)
        text.SetFontSize(16)

    return bar


def draw(actor, bar, options):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    renderer.AddActor2D(bar)

    camera = renderer.GetActiveCamera()
    camera.SetPosition(options.view)
    camera.SetViewUp(options.up)
    renderer.ResetCamera()
    camera.Zoom(1.3)

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(PIXELS)
    window.AddRenderer(renderer)
    window.Render()

    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)

    writer = vtk.vtkPNGWriter()
    writer.SetFileName(options.picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main():
    options = arguments()
    actor, colours = coloured(read_wall(options), options)
    draw(actor, legend(colours, options.field), options)


main()
