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

static const char* const script = R"(if "__file__" in globals():
    folder = os.path.dirname(os.path.abspath(__file__))


def read(name):
    source = LegacyVTKReader(FileNames=[os.path.join(folder, name)])
    RenameSource(name, source)
    return source


wall = read("wall.vtk")
layers = read("layers.vtk")
wall.UpdatePipeline()
bounds = wall.GetDataInformation().GetBounds()
centre = [(bounds[2*i] + bounds[2*i + 1])/2 for i in range(3)]
sizes = [bounds[2*i + 1] - bounds[2*i] for i in range(3)]

left = CreateView("RenderView")
shown = Show(wall, left)
ColorBy(shown, ("CELLS", "thicknessOverRequest"))
colours = GetColorTransferFunction("thicknessOverRequest")
colours.RescaleTransferFunction(0, 1)
shown.SetScalarBarVisibility(left, True)

poor = Threshold(Input=wall)
poor.Scalars = ["CELLS", "worstRelativeJacobian"]
if hasattr(poor, "UpperThreshold"):
    poor.LowerThreshold = -1e30
    poor.UpperThreshold = 0.2
    poor.ThresholdMethod = "Between"
else:
    poor.ThresholdRange = [-1e30, 0.2]
RenameSource("poor faces", poor)
marked = Show(poor, left)
marked.Representation = "Surface With Edges"
marked.ColorArrayName = [None, ""]
marked.DiffuseColor = [1, 0, 0]

# Across the shortest side of the body
normal = [0, 0, 0]
normal[sizes.index(min(sizes))] = 1
right = CreateView("RenderView")
for source in (layers, wall):
    cut = Slice(Input=source)
    cut.SliceType = "Plane"
    cut.SliceType.Origin = centre
    cut.SliceType.Normal = normal
    line = Show(cut, right)
    line.ColorArrayName = [None, ""]
    line.AmbientColor = line.DiffuseColor = [0, 0, 0]
    line.LineWidth = 3 if source is wall else 1

for view in (left, right):
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    ResetCamera(view)

layout = CreateLayout("harmonicPrismMesh")
layout.AssignView(0, left)
layout.SplitViewHorizontal(left)
layout.AssignView(2, right)

direction = [0, 0, 0]
direction[normal.index(1)] = 1
right.CameraFocalPoint = centre
right.CameraPosition = [c + 4*max(sizes)*d for c, d in zip(centre, direction)]
right.CameraViewUp = [0, 1, 0] if direction[1] == 0 else [0, 0, 1]
ResetCamera(right)
RenderAllViews()
)";


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void writeParaviewScript(const fileName& file)
{
    std::ofstream os(file);
    os  << R"(# Shows what harmonicPrismMesh -writeFields has written:
#
#     paraview --script=show.py
#
# Left: the wall, coloured by the thickness of the layers over the request, with
# the poor faces in red: those whose cells have less than a fifth of the scaled
# Jacobian that low cells would have there. Right: the layers in a cut.
)" << "import os\nfrom paraview.simple import *\n\n"
        << "folder = " << '"' << file.path().c_str() << "\"\n"
        << script;

    if (!os.flush())
    {
        FatalErrorInFunction << "Cannot write " << file << exit(FatalError);
    }
}

} // End namespace Foam

// ************************************************************************* //
