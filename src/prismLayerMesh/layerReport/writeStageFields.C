/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeStageFields.H"
#include "error.H"
#include "harmonicField.H"
#include "levelSetReport.H"
#include "OSspecific.H"
#include "patchReport.H"
#include "scaledJacobian.H"
#include "unitConversion.H"
#include "wallPointsError.H"
#include "writeVtk.H"

#include <fstream>

namespace Foam
{

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


//- Writes a script for ParaView that shows wall.vtk and layers.vtk, both in
//  its folder: thickness over the request, poor faces, and layers in a cut.
//  Errors: FatalError if the file cannot be written
static void writeParaviewScript(const fileName& file)
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


// * * * * * * * * * * * * *  Write Stage Fields * * * * * * * * * * * * * * //

//- A level of the field that is near to the envelope
static const scalar envelopeLevel = 0.02;


static void addFace(vtkGrid& grid, const face& f)
{
    grid.addCell
    (
        f.size() == 3 ? vtkCell::triangle
      : f.size() == 4 ? vtkCell::quad
      : vtkCell::polygon,
        f
    );
}


static vtkGrid envelopeGrid(const prismLayerMesh& mesh)
{
    vtkGrid grid;
    faceList triangles;
    levelSetTriangles
    (
        mesh.guide.fields.background, mesh.guide.field, envelopeLevel,
        grid.points, triangles
    );

    for (const face& f : triangles)
    {
        addFace(grid, f);
    }

    return grid;
}


static vtkGrid backgroundGrid(const prismLayerMesh& mesh)
{
    const backgroundMesh& background = mesh.guide.fields.background;

    vtkGrid grid;
    grid.points = background.points;

    for (const tetCell& tet : background.tets)
    {
        grid.addCell(vtkCell::tetra, tet);
    }

    grid.pointFields.add("HIsotropic", mesh.guide.fields.isotropic);
    grid.pointFields.add("H", mesh.guide.field);
    grid.pointFields.add("gradH", pointGradients(background, mesh.guide.field));
    grid.pointFields.add("T", mesh.guide.fields.tensors);
    grid.pointFields.add("gap", background.gaps);

    return grid;
}


static vtkGrid columnGrid(const prismLayerMesh& mesh)
{
    const prismLayers& layers = mesh.made.layers;
    const label n = layers.nLayers;

    vtkGrid grid;
    grid.points = layers.points;

    scalarField energies(layers.points.size());
    for (label c = 0; c < layers.nColumns(); ++c)
    {
        grid.addCell(vtkCell::polyLine, identity(n + 1, layers.index(c, 0)));

        energies[layers.index(c, 0)] = 1;
        for (label i = 1; i <= n; ++i)
        {
            energies[layers.index(c, i)] =
                mesh.guide.lines.energies[c*n + i - 1];
        }
    }
    grid.pointFields.add("samplingEnergy", energies);

    return grid;
}


static vtkGrid layerGrid(const prismLayerMesh& mesh)
{
    const prismLayers& layers = mesh.made.layers;

    vtkGrid grid;
    grid.points = layers.points;

    DynamicList<scalar> numbers;
    for (label i = 0; i <= layers.nLayers; ++i)
    {
        for (const face& f : layers.faces)
        {
            face level(f);
            for (label& p : level)
            {
                p = layers.index(p, i);
            }
            addFace(grid, level);
            numbers.append(i);
        }
    }
    grid.cellFields.add("layer", numbers);

    return grid;
}


//- The largest value on the edges of each face
static scalarField largestOfFaces
(
    const label nFaces,
    const wallAddressing& addressing,
    const scalarField& ofEdges
)
{
    scalarField largest(nFaces, 0);
    forAll(ofEdges, edgei)
    {
        for (const label facei : addressing.edgeFaces[edgei])
        {
            if (facei >= 0)
            {
                largest[facei] = max(largest[facei], ofEdges[edgei]);
            }
        }
    }

    return largest;
}


static void addPointFields(const prismLayerMesh& mesh, vtkGrid& grid)
{
    const label nPoints = grid.points.size();
    scalarField causes(nPoints), angles(nPoints);
    for (label p = 0; p < nPoints; ++p)
    {
        causes[p] = scalar(int(mesh.made.causes[p]));
        angles[p] = radToDeg(::acos(min(mesh.visibility.cones[p].cosine, 1.0)));
    }

    vtkFields& fields = grid.pointFields;
    fields.add("squeezeCause", causes);
    fields.add("visibilityAngle", angles);
    fields.add("firstHeightRequest", mesh.request.firstThickness);
    fields.add("thicknessRequest", mesh.request.thickness);
    fields.add("clearance", SubList<scalar>(mesh.clearance, nPoints));
}


static void addFaceFields
(
    const wallSurface& wall,
    const prismLayerMesh& mesh,
    vtkFields& fields
)
{
    const label nFaces = wall.faces.size();
    const faceHeights heights
    (
        makeFaceHeights(wall, mesh.request, mesh.made.layers)
    );
    const scalarField worst
    (
        SubList<scalar>(mesh.certificate.worstJacobian, nFaces)
    );
    scalarField best
    (
        attainableJacobians
        (
            mesh.share.front.surface, mesh.share.front.visibility
        )
    );
    best.setSize(nFaces);

    fields.add("firstHeight", heights.first);
    fields.add("firstHeightOverRequest", heights.firstOverRequest);
    fields.add("thicknessOverRequest", heights.totalOverRequest);
    fields.add
    (
        "firstHeightChange", largestOfFaces
        (
            nFaces, mesh.addressing,
            changesOverEdges(mesh.addressing.edgeFaces, heights.first)
        )
    );
    fields.add("layers", scalarField(nFaces, mesh.made.layers.nLayers));
    fields.add("worstJacobian", worst);
    fields.add("worstRelativeJacobian", scalarField(worst/max(best, VSMALL)));
}


static vtkGrid wallGrid(const wallSurface& wall, const prismLayerMesh& mesh)
{
    vtkGrid grid;
    grid.points = wall.points;
    for (const face& f : wall.faces)
    {
        addFace(grid, f);
    }

    addPointFields(mesh, grid);
    addFaceFields(wall, mesh, grid.cellFields);

    return grid;
}


void writeStageFields
(
    const fileName& folder,
    const wallSurface& wall,
    const prismLayerMesh& mesh
)
{
    mkDir(folder);

    if (mesh.guide.fields.failure.empty())
    {
        writeVtk(folder/"envelope.vtk", envelopeGrid(mesh));
        writeVtk(folder/"backgroundMesh.vtk", backgroundGrid(mesh));
    }

    writeVtk(folder/"columns.vtk", columnGrid(mesh));
    writeVtk(folder/"layers.vtk", layerGrid(mesh));

    vtkGrid onWall(wallGrid(wall, mesh));

    // An earlier run may have left one
    rm(folder/"levelSets");

    if (hasLevelSetReport(mesh))
    {
        const levelSetReport levelSets(makeLevelSetReport(mesh));
        onWall.pointFields.add("firstLevelSet", levelSets.first);
        onWall.pointFields.add("lastLevelSet", levelSets.last);

        writeReport(folder/"levelSets", toDictionary(levelSets));
    }

    writeVtk(folder/"wall.vtk", onWall);
    writeParaviewScript(folder/"show.py");
}


void writeFailedPoints(const fileName& file, const wallPointsError& failure)
{
    vtkGrid grid;
    grid.points = failure.points();
    forAll(grid.points, i)
    {
        grid.addCell(vtkCell::vertex, labelList(1, i));
    }

    const labelList& labels = failure.labels();
    scalarField wallPoints(labels.size());
    std::copy(labels.begin(), labels.end(), wallPoints.begin());
    grid.pointFields.add("wallPoint", wallPoints);
    writeVtk(file, grid);
}

} // End namespace Foam

// ************************************************************************* //
