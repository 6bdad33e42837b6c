#!/usr/bin/env python3
#------------------------------------------------------------------------------
# Draws pictures of cases that harmonicPrismMesh -writeFields has run in: panels
# of one height beside each other, in one PNG file. Needs VTK for Python (Debian:
# python3-vtk9) and a display, or xvfb-run.
#
#     doc/pictures/draw.py <case> <picture> <panel>...
#
# A panel is one of these, each with entries 'name=value', after commas; vectors
# are 'x y z':
#
#     body    the wall, coloured by a field of wall.vtk
#             view, up    towards the eye, and up in the picture
#             field       default thicknessOverRequest
#             centre, height  of what is shown; default: all of the wall
#             slice       normal of a plane through the centre: the mesh in it
#     cut     the cells of the mesh in a plane
#             centre, normal, up, height
#             field       of the last time: cells are coloured by its magnitude,
#                         over the largest one in the plane; default: layers in
#                         one colour, other cells in another
#             turns       angles about the z axis: the mesh is shown again, turned
#                         by them, beside a cyclic side
#             regions     names: the meshes of these regions, each in its colours
#
# All panels have one colour map, from 0 to 1, and a scale in metres. Only body
# needs -writeFields.
#------------------------------------------------------------------------------
import math
import os
import sys
import vtk

PANEL = (620, 440)
LAYERS = (0.75, 0.86, 0.95)
FAR = (0.97, 0.97, 0.97)

# The same of each region
REGIONS = ((LAYERS, FAR), ((0.98, 0.83, 0.62), (1.00, 0.93, 0.83)),
           ((0.70, 0.86, 0.68), (0.88, 0.96, 0.86)))
LINES = (0.25, 0.25, 0.25)

# Perceived as even, and told apart by all eyes: from low to full
COLOURS = ((0.27, 0.00, 0.33), (0.23, 0.32, 0.55), (0.13, 0.57, 0.55),
           (0.37, 0.79, 0.38), (0.99, 0.91, 0.15))


def fail(text):
    sys.exit("draw.py: " + text)


def panel_of(text):
    """Kind and entries of a panel"""
    kind, *entries = text.split(",")
    values = dict(entry.split("=", 1) for entry in entries)
    if kind not in ("body", "cut"):
        fail("no panel '" + kind + "'")

    return kind, values


def vector(values, name, default):
    text = values.get(name)

    return tuple(map(float, text.split())) if text else default


def read_wall(case):
    file = os.path.join(case, "postProcessing/harmonicPrismMesh/wall.vtk")
    if not os.path.exists(file):
        fail("no " + file + "; run harmonicPrismMesh -writeFields")

    reader = vtk.vtkGenericDataObjectReader()
    reader.SetFileName(file)
    reader.ReadAllScalarsOn()
    reader.Update()

    return reader.GetOutput()


def read_mesh(case, region=None):
    """The cells of constant/polyMesh, or of a region, with their labels, and with the
    fields of the last time"""
    stub = os.path.join(case, "draw.foam")
    open(stub, "w").close()
    try:
        reader = vtk.vtkOpenFOAMReader()
        reader.SetFileName(stub)
        reader.UpdateInformation()
        reader.DisableAllPatchArrays()
        reader.SetPatchArrayStatus(
            "/" + region + "/internalMesh" if region else "internalMesh", 1)
        reader.DecomposePolyhedraOff()
        reader.CreateCellToPointOff()
        times = reader.GetTimeValues()
        reader.SetTimeValue(times.GetRange()[1] if times.GetNumberOfValues() else 0)
        reader.Update()
    finally:
        os.remove(stub)

    blocks = reader.GetOutput().NewIterator()
    mesh = blocks.GetCurrentDataObject()
    if mesh is None or mesh.GetNumberOfCells() == 0:
        fail("no mesh in " + case)

    # The layers come first: they are prisms or hexahedra in stacks
    labels = vtk.vtkIntArray()
    labels.SetName("cell")
    labels.SetNumberOfValues(mesh.GetNumberOfCells())
    for i in range(mesh.GetNumberOfCells()):
        labels.SetValue(i, i)
    mesh.GetCellData().AddArray(labels)

    return mesh


def layer_cells(case, region=None):
    """The number of cells of layers, which come first"""
    file = os.path.join(case, "postProcessing/harmonicPrismMesh", region or "", "report")
    with open(file) as text:
        lines = iter(text)
        for line in lines:
            if line.split() == ["certificate"]:
                break
        cells = 0
        for line in lines:
            words = line.replace(";", " ").split()
            if words[:1] == ["layerCells"]:
                return int(words[1])        # of polygons
            if words[:1] == ["cells"] and not cells:
                cells = int(words[1])
        if cells:
            return cells
    if region:
        return 0
    fail("no cells in " + file)


def colour_map():
    table = vtk.vtkColorTransferFunction()
    for i, colour in enumerate(COLOURS):
        table.AddRGBPoint(i/(len(COLOURS) - 1), *colour)

    return table


def cut_of(mesh, centre, normal):
    plane = vtk.vtkPlane()
    plane.SetOrigin(centre)
    plane.SetNormal(normal)
    cutter = vtk.vtkCutter()
    cutter.SetInputData(mesh)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOff()
    cutter.Update()

    return cutter.GetOutput()


def cut_of_turns(mesh, angles, centre, normal):
    """Of the mesh, and of the mesh turned about the z axis by each angle"""
    cuts = vtk.vtkAppendPolyData()
    for angle in (0, *angles):
        turn = vtk.vtkTransform()
        turn.RotateZ(angle)
        turned = vtk.vtkTransformFilter()
        turned.SetInputData(mesh)
        turned.SetTransform(turn)
        turned.Update()
        cuts.AddInputData(cut_of(turned.GetOutput(), centre, normal))
    cuts.Update()

    return cuts.GetOutput()


def add_cut(renderer, cut, colour_of, width):
    """Cells in a plane; colour_of: of each of them"""
    colours = vtk.vtkUnsignedCharArray()
    colours.SetNumberOfComponents(3)
    colours.SetName("colour")
    for i in range(cut.GetNumberOfCells()):
        colours.InsertNextTuple3(*(255*c for c in colour_of(i)))
    cut.GetCellData().SetScalars(colours)

    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(cut)
    mapper.SetScalarModeToUseCellData()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(*LINES)
    actor.GetProperty().SetLineWidth(width)
    renderer.AddActor(actor)


def add_layers(renderer, case, cut, width, region=None, colours=REGIONS[0]):
    """Layers in one colour, other cells in another"""
    n = layer_cells(case, region)
    cells = cut.GetCellData().GetArray("cell")
    add_cut(renderer, cut, lambda i: colours[cells.GetValue(i) >= n], width)


def add_regions(renderer, case, regions, centre, normal, width):
    for i, region in enumerate(regions):
        cut = cut_of(read_mesh(case, region), centre, normal)
        add_layers(renderer, case, cut, width, region, REGIONS[i % len(REGIONS)])


def add_field(renderer, cut, field, width):
    """Cells by the magnitude of a field, over the largest one"""
    values = cut.GetCellData().GetArray(field)
    if values is None:
        fail("no field " + field)
    sizes = [math.hypot(*values.GetTuple(i))
             for i in range(values.GetNumberOfTuples())]
    largest = max(sizes)
    table = colour_map()
    add_cut(renderer, cut, lambda i: table.GetColor(sizes[i]/largest), width)


def look(renderer, centre, view, up, height):
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    length = math.sqrt(sum(v*v for v in view))
    camera.SetFocalPoint(centre)
    camera.SetPosition([c + 1000*height*v/length for c, v in zip(centre, view)])
    camera.SetViewUp(up)
    camera.SetParallelScale(height/2)
    renderer.ResetCameraClippingRange()


def label(renderer, text, x, y, size=18):
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    actor.GetTextProperty().SetFontSize(size)
    actor.GetTextProperty().SetColor(0, 0, 0)
    actor.SetPosition(x, y)
    renderer.AddActor2D(actor)


def add_scale(renderer, height):
    """A bar of a round length, about a sixth of the panel wide"""
    width = height*PANEL[0]/PANEL[1]
    digit = 10**math.floor(math.log10(width/6))
    length = max(k*digit for k in (1, 2, 5) if k*digit <= width/6)
    pixels = PANEL[0]*length/width

    points = vtk.vtkPoints()
    lines = vtk.vtkCellArray()
    for x in (20, 20 + pixels):
        points.InsertNextPoint(x, 22, 0)
    lines.InsertNextCell(2, (0, 1))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    mapper = vtk.vtkPolyDataMapper2D()
    mapper.SetInputData(data)
    actor = vtk.vtkActor2D()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0, 0, 0)
    actor.GetProperty().SetLineWidth(4)
    renderer.AddActor2D(actor)
    label(renderer, "%g m" % length, 20, 28)


def add_colours(renderer, field):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colour_map())
    bar.SetOrientationToHorizontal()
    bar.SetPosition(0.55, 0.02)
    bar.SetWidth(0.42)
    bar.SetHeight(0.09)
    bar.SetNumberOfLabels(2)
    bar.SetLabelFormat("%.1f")
    bar.SetTitle(field)
    bar.UnconstrainedFontSizeOn()
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0, 0, 0)
        text.SetFontSize(15)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    renderer.AddActor2D(bar)


def draw_body(renderer, case, values):
    wall = read_wall(case)
    field = values.get("field", "thicknessOverRequest")
    bounds = wall.GetBounds()
    middle = tuple((bounds[2*i] + bounds[2*i + 1])/2 for i in range(3))
    centre = vector(values, "centre", middle)
    diagonal = math.dist(bounds[::2], bounds[1::2])
    height = float(values.get("height", 0.75*diagonal))

    mapper = vtk.vtkDataSetMapper()
    mapper.SetInputData(wall)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(field)
    mapper.SetLookupTable(colour_map())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetAmbient(0.25)
    renderer.AddActor(actor)

    if "slice" in values:
        cut = cut_of(read_mesh(case), centre, vector(values, "slice", None))
        add_layers(renderer, case, cut, 1)

    look(renderer, centre, vector(values, "view", (1, -1, 0.6)),
         vector(values, "up", (0, 0, 1)), height)
    add_scale(renderer, height)
    add_colours(renderer, field)


def draw_cut(renderer, case, values):
    centre = vector(values, "centre", None)
    normal = vector(values, "normal", (0, 0, 1))
    height = float(values["height"])
    if "regions" in values:
        add_regions(renderer, case, values["regions"].split(), centre, normal, 1.5)
    else:
        turns = vector(values, "turns", ())
        cut = cut_of_turns(read_mesh(case), turns, centre, normal)
        if "field" in values:
            add_field(renderer, cut, values["field"], 1)
        else:
            add_layers(renderer, case, cut, 1.5)
    look(renderer, centre, normal, vector(values, "up", (0, 1, 0)), height)
    add_scale(renderer, height)


def main():
    if len(sys.argv) < 4:
        fail("usage: draw.py <case> <picture> <panel>...; see the script")
    case, picture, *panels = sys.argv[1:]

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(PANEL[0]*len(panels), PANEL[1])
    for i, panel in enumerate(map(panel_of, panels)):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(i/len(panels), 0, (i + 1)/len(panels), 1)
        renderer.SetBackground(1, 1, 1)
        window.AddRenderer(renderer)
        kind, values = panel
        (draw_body if kind == "body" else draw_cut)(renderer, case, values)
    window.Render()

    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetFileName(picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


main()
