/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreZones.H"
#include "ListOps.H"
#include "makeFarFieldMesh.H"
#include "Map.H"
#include "meshBuilder.H"

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

    //- Labels here of the core's points and faces, and of the cut's triangles
    labelList points_;
    labelList faces_;
    labelList cutFaces_;

    //- The patches of the core are the last
    label firstCorePatch_;

    meshBuilder made_;
    farFieldMesh mesh_;

    label nTets() const { return tets_.tets.size(); }

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
            const label other = t.beyond(facei);
            const bool stays =
                cells_[t.owner[facei]] >= 0
             || (other >= 0 && cells_[other] >= 0);

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
    void takeFace(const label facei, const label first, const label second)
    {
        face f(std::move(core_.topology.faces[facei]));
        inplaceRenumber(points_, f);
        faces_[facei] = made_.size();
        made_.append(f, first, second);
    }

    //- Internal faces of tetrahedra, with those to cells of the core
    void addTetFaces()
    {
        forAll(tets_.tets, t)
        {
            for (label i = 0; i < 4; ++i)
            {
                const label other = tets_.neighbours[t][i];
                if (other > t)
                {
                    made_.append
                    (
                        tets_.tets[t].face(i).triFaceFace(), t, other
                    );
                }
            }
        }
        forAllReverse(tets_.cutTriangles, i)
        {
            cutFaces_[i] = made_.size();
            made_.append
            (
                tets_.cutTriangles[i].reverseFace(), boundary_.onCut[i],
                nTets() + cells_[tets_.cutCells[i]]
            );
        }
    }

    void addCoreFaces()
    {
        const polyMeshTopology& t = core_.topology;
        forAll(t.neighbour, facei)
        {
            const label own = cells_[t.owner[facei]];
            const label nei = cells_[t.neighbour[facei]];

            if (own >= 0 && nei >= 0)
            {
                takeFace(facei, nTets() + own, nTets() + nei);
            }
        }
    }

    void addOuterFaces()
    {
        forAll(tets_.outerTriangles, i)
        {
            made_.append
            (
                tets_.outerTriangles[i].reverseFace(), boundary_.onLayers[i],
                meshBuilder::onPatch(0)
            );
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
            const label second = meshBuilder::onPatch(1 + patchi);
            for (const label i : triangles[patchi])
            {
                made_.append
                (
                    tets_.boundaryTriangles[i].reverseFace(),
                    boundary_.onPatches[i], second
                );
            }

            const label corePatch = patchi - firstCorePatch_;
            if (corePatch < 0)
            {
                continue;
            }
            for (const label facei : core_.topology.patchFaces(corePatch))
            {
                const label own = cells_[core_.topology.owner[facei]];
                if (own >= 0)
                {
                    takeFace(facei, nTets() + own, second);
                }
            }
        }
    }

    //- Puts the faces in order, and adds the zones
    void finish()
    {
        const label nPatches = 1 + mesh_.patches.names.size();
        const labelList order(made_.order(mesh_.nCells, nPatches));
        mesh_.topology = made_.topology(order, nPatches);
        const labelList newFaces(invert(made_.size(), order));
        inplaceRenumber(newFaces, faces_);
        inplaceRenumber(newFaces, cutFaces_);
        Map<DynamicList<label>> ofCoreFaces;
        for (const label i : sortedOrder(cutFaces_))
        {
            ofCoreFaces(tets_.cutFaces[i]).append(cutFaces_[i]);
        }
        mesh_.cellZones.append(cellZoneParts(farFieldName, identity(nTets())));
        mesh_.cellZones.append(coreCellZones(tets_, core_, cut_, boundary_));
        mesh_.faceZones.append
        (
            coreFaceZones(core_, cells_, faces_, ofCoreFaces)
        );
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
        faces_(core.topology.faces.size(), -1),
        cutFaces_(tets.cutTriangles.size())
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
        addPoints();
        addTetFaces();
        addCoreFaces();
        addOuterFaces();
        addPatches();
        finish();

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
