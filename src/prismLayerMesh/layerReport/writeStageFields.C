/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeStageFields.H"
#include "faceHeights.H"
#include "scaledJacobian.H"
#include "harmonicField.H"
#include "levelSetReport.H"
#include "OSspecific.H"
#include "paraviewScript.H"
#include "unitConversion.H"
#include "wallPointsError.H"
#include "writeVtk.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
