/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "writeStageFields.H"
#include "faceHeights.H"
#include "scaledJacobian.H"
#include "harmonicField.H"
#include "levelSetReport.H"
#include "IOobject.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "unitConversion.H"
#include "writeVtk.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A level between the envelope and what is near to it
static const scalar envelopeLevel = 0.02;


static vtkCell cellType(const face& f)
{
    return f.size() == 3 ? vtkCell::triangle
         : f.size() == 4 ? vtkCell::quad
         : vtkCell::polygon;
}


static vtkGrid envelopeGrid(const prismLayerMesh& mesh)
{
    vtkGrid grid;
    faceList triangles;
    levelSetTriangles
    (
        mesh.background, mesh.field, envelopeLevel, grid.points, triangles
    );

    for (const face& f : triangles)
    {
        grid.addCell(vtkCell::triangle, f);
    }

    return grid;
}


static vtkGrid backgroundGrid(const prismLayerMesh& mesh)
{
    const backgroundMesh& background = mesh.background;

    vtkGrid grid;
    grid.points = background.points;

    for (const tetCell& tet : background.tets)
    {
        grid.addCell(vtkCell::tetra, tet);
    }

    grid.pointFields.add("HIsotropic", mesh.isotropic);
    grid.pointFields.add("H", mesh.field);
    grid.pointFields.add("gradH", pointGradients(background, mesh.field));
    grid.pointFields.add("T", mesh.tensors);
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
        grid.addCell
        (
            vtkCell::polyLine, identity(n + 1, layers.index(c, 0))
        );

        energies[layers.index(c, 0)] = 1;
        for (label i = 1; i <= n; ++i)
        {
            energies[layers.index(c, i)] =
                mesh.lines.energies[c*n + i - 1];
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
            grid.addCell(cellType(f), level);
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
            largest[facei] = max(largest[facei], ofEdges[edgei]);
        }
    }

    return largest;
}


static vtkGrid wallGrid(const wallSurface& wall, const prismLayerMesh& mesh)
{
    const layerSpacing& request = mesh.request;
    const prismLayers& layers = mesh.made.layers;

    vtkGrid grid;
    grid.points = wall.points;
    for (const face& f : wall.faces)
    {
        grid.addCell(cellType(f), f);
    }

    const label nPoints = wall.points.size();
    scalarField causes(nPoints), angles(nPoints);

    for (label p = 0; p < nPoints; ++p)
    {
        causes[p] = scalar(int(mesh.made.causes[p]));
        angles[p] = radToDeg(::acos(min(mesh.visibility.cones[p].cosine, 1.0)));
    }

    grid.pointFields.add("squeezeCause", causes);
    grid.pointFields.add("visibilityAngle", angles);
    grid.pointFields.add("firstHeightRequest", request.firstThickness);
    grid.pointFields.add("thicknessRequest", request.thickness);
    grid.pointFields.add
    (
        "clearance", scalarField(SubList<scalar>(mesh.clearance, nPoints))
    );

    const faceHeights heights(makeFaceHeights(wall, request, layers));
    grid.cellFields.add("firstHeight", heights.first);
    grid.cellFields.add("firstHeightOverRequest", heights.firstOverRequest);
    grid.cellFields.add("thicknessOverRequest", heights.totalOverRequest);
    grid.cellFields.add
    (
        "firstHeightChange", largestOfFaces
        (
            wall.faces.size(), mesh.addressing,
            changesOverEdges(mesh.addressing, heights.first)
        )
    );
    grid.cellFields.add
    (
        "layers", scalarField(wall.faces.size(), layers.nLayers)
    );
    grid.cellFields.add
    (
        "worstJacobian",
        scalarField
        (
            SubList<scalar>(mesh.certificate.worstJacobian, wall.faces.size())
        )
    );

    const scalarField best
    (
        attainableJacobians(mesh.front.surface, mesh.front.visibility)
    );
    scalarField relative(wall.faces.size());
    forAll(relative, facei)
    {
        relative[facei] =
            mesh.certificate.worstJacobian[facei]/max(best[facei], VSMALL);
    }
    grid.cellFields.add("worstRelativeJacobian", relative);

    return grid;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::writeStageFields
(
    const fileName& folder,
    const wallSurface& wall,
    const prismLayerMesh& mesh
)
{
    mkDir(folder);

    if (mesh.noField.empty())
    {
        writeVtk(folder/"envelope.vtk", envelopeGrid(mesh));
        writeVtk(folder/"backgroundMesh.vtk", backgroundGrid(mesh));
    }

    writeVtk(folder/"columns.vtk", columnGrid(mesh));
    writeVtk(folder/"layers.vtk", layerGrid(mesh));

    vtkGrid onWall(wallGrid(wall, mesh));

    // Not those of an earlier run
    rm(folder/"levelSets");

    if (hasLevelSetReport(mesh))
    {
        const levelSetReport levelSets(makeLevelSetReport(mesh));
        onWall.pointFields.add("firstLevelSet", levelSets.first);
        onWall.pointFields.add("lastLevelSet", levelSets.last);

        OFstream os(folder/"levelSets");
        IOobject::writeBanner(os);
        toDictionary(levelSets).write(os, false);
        IOobject::writeEndDivider(os);
    }

    writeVtk(folder/"wall.vtk", onWall);
}


// ************************************************************************* //
