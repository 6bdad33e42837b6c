/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionMeshes.H"
#include "equalPoints.H"
#include "meshCell.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The cells at some points
static bitSet cellsAt(const bitSet& points, const polyMeshParts& mesh)
{
    bitSet cells(mesh.nCells);
    const polyMeshTopology& t = mesh.topology;
    forAll(t.faces, f)
    {
        for (const label p : t.faces[f])
        {
            if (points.test(p))
            {
                cells.set(t.owner[f]);
                cells.set(t.beyond(f));
            }
        }
    }

    return cells;
}


//- Whether each point of a mesh is on the boundary of its region
static boolList onBoundary
(
    const wallSurface& boundary,
    const pointField& points
)
{
    equalPoints places;
    forAll(boundary.points, p)
    {
        places.insert(boundary.points[p], p);
    }
    boolList isOn(points.size());
    forAll(isOn, p)
    {
        isOn[p] = places.find(points[p]) >= 0;
    }

    return isOn;
}


//- Refuses cells at moved points that are not positive, or flat but for
//  rounding
static void requirePositive
(
    const spaceRegion& region,
    const polyMeshParts& mesh,
    const bitSet& isMoved
)
{
    const faceList faces(mesh.topology.faces);
    const labelList owner(mesh.topology.owner);
    const labelList neighbour(mesh.topology.neighbour);
    const polyhedralMesh cells(mesh.points, faces, owner, neighbour);
    const boolList onWall(onBoundary(region.surface, mesh.points));
    meshCell judge(cells, onWall);
    for (const label celli : cellsAt(isMoved, mesh))
    {
        const meshCellVerdict verdict(judge(celli));
        const bool isSnapped =
            verdict.shape == meshCellShape::hexahedron
         && judge.isPositivePolyhedron(celli);
        if (!judge.hasVolume() || !(verdict.positive || isSnapped))
        {
            FatalErrorInFunction
                << "The boundary of the region " << region.name
                << " touches itself, and a cell there is flat, at "
                << cells.centre(celli) << nl
                << "Remesh the surface here, separate the touching parts, or"
                << " add layers to this region" << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void closeRegion
(
    spaceRegions& all,
    const label regioni,
    polyMeshParts& mesh
)
{
    const bitSet isMoved(all.close(regioni, mesh.points));
    if (isMoved.any())
    {
        requirePositive(all.regions[regioni], mesh, isMoved);
    }
}

} // End namespace Foam

// ************************************************************************* //
