/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeFarFieldMesh.H"
#include "coreCellZones.H"
#include "coreFaceZones.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class cellJoiner
{
    const farFieldTets& tets_;
    polyMeshParts& core_;
    const coreCut& cut_;

    //- Position of each cell of the core among the cells that stay, -1 if the
    //  cell goes
    const labelList cells_;

    const boundaryTets boundary_;

    //- Labels here of the core's points and faces, and of faces that are
    //  several triangles
    labelList points_;
    labelList faces_;
    Map<DynamicList<label>> cutFaces_;

    //- The patches of the core are the last
    label firstCorePatch_;

    farFieldMesh mesh_;

    label nTets() const { return tets_.tets.size(); }

    label nCoreInternal() const { return core_.topology.neighbour.size(); }

    void addPoints();

    //- Takes a face out of the core
    face takeFace(label facei);

    //- Internal faces of tetrahedra, with those to cells of the core
    void addTetFaces();

    void addCoreFaces();

    void addOuterFaces();

    void addPatches();

public:

    cellJoiner
    (
        const farFieldTets& tets,
        polyMeshParts& core,
        const coreCut& cut
    );

    farFieldMesh join();
};


cellJoiner::cellJoiner
(
    const farFieldTets& tets,
    polyMeshParts& core,
    const coreCut& cut
)
:
    tets_(tets),
    core_(core),
    cut_(cut),
    cells_(invert(core.nCells, cut.cells)),
    boundary_(findBoundaryTets(tets)),
    points_(core.points.size(), -1),
    faces_(core.topology.faces.size(), -1)
{
    mesh_.nCells = tets.tets.size() + cut.cells.size();
    firstCorePatch_ = tets.patches.names.size() - core.patches.names.size();
    mesh_.patches = tets.patches;
    forAll(core.patches.entries, patchi)
    {
        mesh_.patches.entries[firstCorePatch_ + patchi] =
            core.patches.entries[patchi];
    }
}


void cellJoiner::addPoints()
{
    forAll(tets_.corePoints, p)
    {
        if (tets_.corePoints[p] >= 0)
        {
            points_[tets_.corePoints[p]] = p;
        }
    }

    // Further points of cells that stay
    const polyMeshTopology& t = core_.topology;
    DynamicList<point> points(tets_.points.size() + core_.points.size());
    points.append(tets_.points);
    forAll(t.faces, facei)
    {
        const bool stays =
            cells_[t.owner[facei]] >= 0
         || (facei < nCoreInternal() && cells_[t.neighbour[facei]] >= 0);

        for (const label p : t.faces[facei])
        {
            if (stays && points_[p] < 0)
            {
                points_[p] = points.size();
                points.append(core_.points[p]);
            }
        }
    }

    mesh_.points.transfer(points);
}


face cellJoiner::takeFace(const label facei)
{
    face f(std::move(core_.topology.faces[facei]));
    inplaceRenumber(points_, f);

    return f;
}


void cellJoiner::addTetFaces()
{
    const Map<DynamicList<label>> cutOf(boundary_.cutTriangles());

    // Neighbours, with the face of the tetrahedron, or less than 0 the
    // triangle of the cut
    DynamicList<labelPair> neighbours(4);

    forAll(tets_.tets, t)
    {
        neighbours.clear();
        for (label i = 0; i < 4; ++i)
        {
            if (tets_.neighbours[t][i] > t)
            {
                neighbours.append(labelPair(tets_.neighbours[t][i], i));
            }
        }
        if (cutOf.found(t))
        {
            for (const label i : cutOf[t])
            {
                const label celli = cells_[tets_.cutCells[i]];
                neighbours.append(labelPair(nTets() + celli, -1 - i));
            }
        }
        std::sort(neighbours.begin(), neighbours.end());

        for (const labelPair& b : neighbours)
        {
            const label i = b.second();
            if (i < 0)
            {
                cutFaces_(tets_.cutFaces[-1 - i]).append
                (
                    mesh_.topology.faces.size()
                );
            }
            mesh_.topology.append
            (
                i < 0
              ? tets_.cutTriangles[-1 - i].reverseFace()
              : tets_.tets[t].face(i).triFaceFace(),
                t,
                b.first()
            );
        }
    }
}


void cellJoiner::addCoreFaces()
{
    const polyMeshTopology& t = core_.topology;
    for (label facei = 0; facei < nCoreInternal(); ++facei)
    {
        const label own = cells_[t.owner[facei]];
        const label nei = cells_[t.neighbour[facei]];

        if (own >= 0 && nei >= 0)
        {
            faces_[facei] = mesh_.topology.faces.size();
            const label first = nTets();
            mesh_.topology.append(takeFace(facei), first + own, first + nei);
        }
    }
}


void cellJoiner::addOuterFaces()
{
    mesh_.topology.startPatch();
    forAll(tets_.outerTriangles, i)
    {
        face f(tets_.outerTriangles[i].reverseFace());
        mesh_.topology.append(std::move(f), boundary_.onLayers[i]);
    }
    mesh_.frontFaces = tets_.outerFaces;
}


void cellJoiner::addPatches()
{
    // Seen from inside, the normals of the boundary's triangles point at us
    const labelListList triangles
    (
        invertOneToMany(tets_.patches.names.size(), tets_.patchIDs)
    );

    forAll(mesh_.patches.names, patchi)
    {
        mesh_.topology.startPatch();
        for (const label i : triangles[patchi])
        {
            face f(tets_.boundaryTriangles[i].reverseFace());
            mesh_.topology.append(std::move(f), boundary_.onPatches[i]);
        }

        const label corePatch = patchi - firstCorePatch_;
        if (corePatch < 0)
        {
            continue;
        }
        const label start = core_.topology.patchStarts[corePatch];
        const label end = start + core_.topology.patchSizes[corePatch];
        for (label facei = start; facei < end; ++facei)
        {
            const label own = cells_[core_.topology.owner[facei]];
            if (own >= 0)
            {
                faces_[facei] = mesh_.topology.faces.size();
                mesh_.topology.append(takeFace(facei), nTets() + own);
            }
        }
    }
}


farFieldMesh cellJoiner::join()
{
    const label nFaces = 2*nTets() + core_.topology.faces.size();
    addPoints();
    mesh_.topology.reserve(nFaces, nFaces);
    addTetFaces();
    addCoreFaces();
    addOuterFaces();
    addPatches();
    mesh_.cellZones.append(cellZoneParts(farFieldName, identity(nTets())));
    mesh_.cellZones.append(coreCellZones(tets_, core_, cut_, boundary_));
    mesh_.faceZones.append(coreFaceZones(core_, cells_, faces_, cutFaces_));

    return std::move(mesh_);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farFieldMesh joinCells
(
    const farFieldTets& tets,
    polyMeshParts& core,
    const coreCut& cut
)
{
    return cellJoiner(tets, core, cut).join();
}

} // End namespace Foam

// ************************************************************************* //
