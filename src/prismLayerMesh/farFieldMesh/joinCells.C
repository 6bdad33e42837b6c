/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreZones.H"
#include "ListOps.H"
#include "makeFarFieldMesh.H"
#include "Map.H"

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

    void addPoints()
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

    //- Takes a face out of the core
    face takeFace(const label facei)
    {
        face f(std::move(core_.topology.faces[facei]));
        inplaceRenumber(points_, f);

        return f;
    }

    //- Sets the cells across the faces of a tetrahedron that come after it, in
    //  ascending order, with the face of the tetrahedron, or less than 0 the
    //  triangle of the cut
    void setLaterNeighbours
    (
        const label t,
        const Map<DynamicList<label>>& cutOf,
        DynamicList<labelPair>& neighbours
    ) const
    {
        neighbours.clear();
        for (label i = 0; i < 4; ++i)
        {
            if (tets_.neighbours[t][i] > t)
            {
                neighbours.append(labelPair(tets_.neighbours[t][i], i));
            }
        }
        const auto cut = cutOf.cfind(t);
        if (cut.good())
        {
            for (const label i : *cut)
            {
                const label celli = cells_[tets_.cutCells[i]];
                neighbours.append(labelPair(nTets() + celli, -1 - i));
            }
        }
        std::sort(neighbours.begin(), neighbours.end());
    }

    //- Returns the label in the mesh of the first face that each tetrahedron
    //  owns, and then the number of these faces
    labelList firstFaces(const Map<DynamicList<label>>& cutOf) const
    {
        labelList starts(nTets() + 1, 0);
        forAll(tets_.tets, t)
        {
            starts[t + 1] += starts[t] + (cutOf.found(t) ? cutOf[t].size() : 0);
            for (const label neighbour : tets_.neighbours[t])
            {
                starts[t + 1] += neighbour > t;
            }
        }

        return starts;
    }

    //- Internal faces of tetrahedra, with those to cells of the core
    void addTetFaces()
    {
        const Map<DynamicList<label>> cutOf(boundary_.cutTriangles());
        const labelList starts(firstFaces(cutOf));
        polyMeshTopology& topology = mesh_.topology;
        topology.faces.setSize(starts[nTets()]);
        topology.owner.setSize(starts[nTets()]);
        topology.neighbour.setSize(starts[nTets()]);
        labelList cutFaces(tets_.cutTriangles.size());

        #pragma omp parallel
        {
            DynamicList<labelPair> neighbours(4);

            #pragma omp for schedule(static)
            for (label t = 0; t < nTets(); ++t)
            {
                setLaterNeighbours(t, cutOf, neighbours);
                forAll(neighbours, k)
                {
                    const label facei = starts[t] + k;
                    const label i = neighbours[k].second();
                    if (i < 0)
                    {
                        cutFaces[-1 - i] = facei;
                    }
                    topology.faces[facei] =
                        i < 0
                      ? tets_.cutTriangles[-1 - i].reverseFace()
                      : tets_.tets[t].face(i).triFaceFace();
                    topology.owner[facei] = t;
                    topology.neighbour[facei] = neighbours[k].first();
                }
            }
        }
        for (const label i : sortedOrder(cutFaces))
        {
            cutFaces_(tets_.cutFaces[i]).append(cutFaces[i]);
        }
    }

    void addCoreFaces()
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
                mesh_.topology.append
                (
                    takeFace(facei), first + own, first + nei
                );
            }
        }
    }

    void addOuterFaces()
    {
        mesh_.topology.startPatch();
        forAll(tets_.outerTriangles, i)
        {
            face f(tets_.outerTriangles[i].reverseFace());
            mesh_.topology.append(std::move(f), boundary_.onLayers[i]);
        }
        mesh_.frontFaces = tets_.outerFaces;
    }

    void addPatches()
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

public:

    cellJoiner
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

    farFieldMesh join()
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
};

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
