/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "paraviewScript.H"
#include "error.H"

#include <fstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const char* const script = R"python(if "__file__" in globals():
    folder = os.path.dirname(os.path.abspath(__file__))


def read(name):
    source = LegacyVTKReader(FileNames=[os.path.join(folder, name)])
    RenameSource(name, source)
    source.UpdatePipeline()
    return source


def faces(name, low, high):
    """The faces of the wall with a worst relative Jacobian in these bounds"""
    part = Threshold(Input=wall)
    part.Scalars = ["CELLS", "worstRelativeJacobian"]
    if hasattr(part, "UpperThreshold"):
        part.LowerThreshold, part.UpperThreshold = low, high
        part.ThresholdMethod = "Between"
    else:
        part.ThresholdRange = [low, high]
    RenameSource(name, part)
    return part


def new_view(title):
    view = CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    text = Show(Text(Text=title), view)
    text.Color = [0, 0, 0]
    text.FontSize = 12
    return view


def look(view, at, direction, up, height):
    """Looks against a direction, without perspective"""
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = at
    view.CameraPosition = [a + 4*diagonal*d for a, d in zip(at, direction)]
    view.CameraViewUp = up
    view.CameraParallelScale = height/2
    view.CenterOfRotation = at


def thinnest(lines):
    """Where the layers of a cut are thinnest"""
    values = lines.GetCellData().GetArray("thicknessOverRequest")
    cell = min(range(lines.GetNumberOfCells()), key=values.GetValue)
    box = lines.GetCell(cell).GetBounds()
    return [(box[2*i] + box[2*i + 1])/2 for i in range(3)]


wall = read("wall.vtk")
layers = read("layers.vtk")
box = wall.GetDataInformation().GetBounds()
centre = [(box[2*i] + box[2*i + 1])/2 for i in range(3)]
sizes = [box[2*i + 1] - box[2*i] for i in range(3)]
diagonal = sum(size**2 for size in sizes)**0.5
layout = CreateLayout("harmonicPrismMesh")

view = new_view("Thickness over the request, poor faces red")
layout.AssignView(0, view)
shown = Show(faces("faces", 0.2, 1e30), view)
ColorBy(shown, ("CELLS", "thicknessOverRequest"))
colours = GetColorTransferFunction("thicknessOverRequest")
colours.ApplyPreset("Viridis (matplotlib)", True)
colours.RescaleTransferFunction(0, 1)
shown.SetScalarBarVisibility(view, True)
bar = GetScalarBar(colours, view)
bar.Title = ""
bar.LabelColor = [0, 0, 0]
bar.LabelFontSize = 12
marked = Show(faces("poor faces", -1e30, 0.2), view)
marked.ColorArrayName = [None, ""]
marked.DiffuseColor = marked.AmbientColor = [1, 0, 0]
look(view, centre, [0.5, -0.7, 0.5], [0, 0, 1], 1.1*diagonal)

# Across the shortest side of the body, beside a plane of symmetry, which may
# have edges of the mesh in it
across = sizes.index(min(sizes))
normal = [float(i == across) for i in range(3)]
origin = [c + 0.013*s*n for c, s, n in zip(centre, sizes, normal)]
up = [0, 1, 0] if across == 2 else [0, 0, 1]
cuts = []
for source in (layers, wall):
    cut = Slice(Input=source)
    cut.SliceType = "Plane"
    cut.SliceType.Origin = origin
    cut.SliceType.Normal = normal
    cut.UpdatePipeline()
    cuts.append(cut)
thickness = wall.PointData["thicknessRequest"].GetRange()[1]
height = 1.1*max(sizes)
half = layout.SplitViewHorizontal(view) + 1
for cell, title, at, height in (
    (half, "Layers in a cut", origin, height),
    (
        None, "The same, where it is thinnest",
        thinnest(servermanager.Fetch(cuts[1])), min(height, 4*thickness)
    )
):
    if cell is None:
        cell = layout.SplitViewVertical(view) + 1
    view = new_view(title)
    layout.AssignView(cell, view)
    for cut, grey, width in zip(cuts, (0.4, 0), (1, 3)):
        lines = Show(cut, view)
        lines.ColorArrayName = [None, ""]
        lines.AmbientColor = lines.DiffuseColor = 3*[grey]
        lines.LineWidth = width
    look(view, at, normal, up, height)

RenderAllViews()
if sys.argv[-1].endswith(".png"):
    SaveScreenshot(sys.argv[-1], layout, ImageResolution=[1600, 900])
)python";


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void writeParaviewScript(const fileName& file)
{
    std::ofstream os(file);
    os  << R"(# Shows what harmonicPrismMesh -writeFields has written:
#
#     paraview --script=show.py
#     pvbatch show.py picture.png     # without a window: saves a picture
#
# Left: the wall, coloured by the thickness of the layers over the request, with
# the poor faces in red: their cells have less than a fifth of the scaled
# Jacobian that low cells would have there. Right: the layers in a cut, all of
# them and where they are thinnest.
)" << "import os\nimport sys\nfrom paraview.simple import *\n\n"
        << "folder = " << '"' << file.path().c_str() << "\"\n"
        << script;

    if (!os.flush())
    {
        FatalErrorInFunction << "Cannot write " << file << exit(FatalError);
    }
}

} // End namespace Foam

// ************************************************************************* //
