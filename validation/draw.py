#!/usr/bin/env python3
"""Draws the speed on a slice of the last time of cases, with the mesh.

    xvfb-run -a validation/draw.py <level> <case>...

Writes doc/pictures/validation.<case>.png. Needs VTK's Python (Debian: python3-vtk9)."""

import os
import sys

import vtk

HERE = os.path.dirname(os.path.abspath(__file__))

# Normal of the slice, its centre, and half of the height of the picture
VIEWS = {
    "aerofoil": ((0, 0, 1), (0.98, 0, 0.05), 0.05),
    "backwardFacingStep": ((0, 0, 1), (4, 0.8, 0.5), 3.2),
    "cylinderInDuct": ((0, 0, 1), (0.75, 0.2, 0.205), 0.24),
    "flatPlate": ((0, 0, 1), (1, 0.03, 0.05), 0.06),
    "pipe": ((0, 0, 1), (3, 0.25, 0), 0.5),
    "sphere": ((0, 0, 1), (1.5, 0, 0), 1.8),
    "suboff": ((0, -1, 0), (3.7, 0.001, 0.35), 0.7),
}


def lastTime(folder):
    """The name of the last time of a case."""
    times = [t for t in os.listdir(folder) if t.replace(".", "").isdigit()]

    return max(times, key=float)


def slice(folder, normal, centre):
    """The cells of a case that a plane cuts, with the speed."""
    marker = os.path.join(folder, "case.foam")
    open(marker, "w").close()
    reader = vtk.vtkOpenFOAMReader()
    reader.SetFileName(marker)
    reader.CreateCellToPointOff()
    reader.DecomposePolyhedraOff()
    reader.UpdateInformation()
    reader.SetTimeValue(float(lastTime(folder)))
    reader.Update()
    os.remove(marker)

    plane = vtk.vtkPlane()
    plane.SetOrigin(centre)
    plane.SetNormal(normal)
    cutter = vtk.vtkCutter()
    cutter.SetInputData(reader.GetOutput().GetBlock(0))
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOff()
    cutter.Update()

    return cutter.GetOutput()


def draw(level, case):
    normal, centre, height = VIEWS[case]
    folder = os.path.join(HERE, case, "run", level)
    data = slice(folder, normal, centre)
    data.GetCellData().SetActiveVectors("U")

    colours = vtk.vtkLookupTable()
    colours.SetHueRange(0.62, 0.05)
    colours.SetSaturationRange(0.55, 0.75)
    colours.SetValueRange(0.85, 1)
    colours.SetVectorModeToMagnitude()
    speed = data.GetCellData().GetArray("U")
    colours.SetRange(0, speed.GetRange(-1)[1])
    colours.Build()

    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("U")
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.25, 0.25, 0.3)
    actor.GetProperty().SetLineWidth(0.3)
    actor.GetProperty().LightingOff()

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(centre)
    camera.SetPosition([c + n for c, n in zip(centre, normal)])
    camera.SetViewUp((0, 0, 1) if normal[1] else (0, 1, 0))
    camera.SetParallelScale(height)
    renderer.ResetCameraClippingRange()

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(800, 400)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(
        os.path.join(HERE, "../doc/pictures", "validation." + case + ".png"))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


for name in sys.argv[2:]:
    draw(sys.argv[1], name)
