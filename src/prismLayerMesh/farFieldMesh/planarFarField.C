/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarFarField.H"
#include "boundBox.H"
#include "cellPredicates.H"
#include "cyclicColumns.H"
#include "EdgeMap.H"
#include "HashSet.H"
#include "ListOps.H"
#include "makeFarFieldMesh.H"
#include "meshBuilder.H"
#include "planarColumns.H"

#include <algorithm>

namespace Foam
{

namespace
{

//- A side of a prism: an edge of its triangle, as the triangle runs along it
struct prismSide
{
    label cell;
    edge along;
};


//- From the first plane to the second
vector wayAcross(const prismLayers& layers, const labelUList& across)
{
    label c = 0;
    while (across[c] < 0)
    {
        ++c;
    }

    return layers(across[c], 0) - layers(c, 0);
}


//- The front face on each outer edge in the first plane
EdgeMap<label> frontsInPlane
(
    const prismLayers& layers,
    const labelUList& across
)
{
    EdgeMap<label> fronts(layers.faces.size());
    forAll(layers.faces, facei)
    {
        const face& f = layers.faces[facei];
        for (label k = 0; k < f.size(); ++k)
        {
            if (across[f[k]] >= 0 && across[f.nextLabel(k)] >= 0)
            {
                fronts.insert(edge(f[k], f.nextLabel(k)), facei);
            }
        }
    }

    return fronts;
}


//- The ends of sides in the first plane, ascending
labelList endsOf(const UList<prismSide>& sides)
{
    labelHashSet ends;
    for (const prismSide& side : sides)
    {
        ends.insert(side.along);
    }

    return ends.sortedToc();
}


//- Puts sides of a second cyclic patch in the order of the sides of the first
//  one of which they are images
void orderSidesAsImages
(
    const pointField& points,
    const rigidMotion& toSecond,
    const UList<prismSide>& first,
    UList<prismSide>& second
)
{
    const auto refuse = [](const point& at)
    {
        FatalErrorInFunction
            << "The face at " << at << " has no image on the second of two"
            << " cyclic patches" << nl
            << "The wall must be the same on both" << exit(FatalError);
    };
    label lone;
    const Map<label> images
    (
        imagesByLabel
        (
            endsOf(first), endsOf(second),
            [&](const label p) { return points[p]; }, toSecond,
            1e-9*boundBox(points, false).mag(), lone
        )
    );
    if (lone >= 0)
    {
        refuse(points[lone]);
    }
    const auto edgeOf = [](const prismSide& side) { return side.along; };
    lone = orderAsImages(first, second, edgeOf, images);
    if (lone >= 0)
    {
        refuse(first[lone].along.centre(points));
    }
}


//- A prism is so if one part of the wall is not in the fluid of another one
static void refusePrism(const char* how, const point& at)
{
    FatalErrorInFunction
        << "A prism of the far field is " << how << ", at " << at << nl
        << "Is this point inside the fluid? If an open curve faces the wrong"
        << " way, reverse its points" << exit(FatalError);
}


class planarJoiner
{
    const prismLayers& layers_;
    const labelUList& across_;
    const tetBoundary& boundary_;

    //- Labels of the patches in both planes
    label first_;
    label second_;

    //- The triangles in the first plane, with labels of points here
    faceList triangles_;

    //- Labels here of the points of the boundary, and of the image of each
    //  point here
    labelList points_;
    DynamicList<label> images_;

    //- The sides without a neighbour: on the layers, by front face, and on each
    //  patch
    DynamicList<std::pair<label, prismSide>> onLayers_;
    List<DynamicList<prismSide>> onPatches_;

    //- The second patches of cyclic pairs
    labelHashSet isSecond_;

    meshBuilder faces_;
    farFieldMesh mesh_;

    label patchOf(const word& name) const
    {
        return boundary_.surface.patchNames.find(name);
    }

    void addPoints()
    {
        mesh_.points = layers_.outerPoints();
        const label nColumns = mesh_.points.size();
        images_ = across_;

        // The points in the first plane, then their images
        const vector way(wayAcross(layers_, across_));
        const wallSurface& s = boundary_.surface;
        points_ = labelList(s.points.size(), -1);
        SubList<label>(points_, boundary_.columns.size()) = boundary_.columns;
        DynamicList<point> more;
        forAll(s.faces, i)
        {
            for (const label p : s.faces[i])
            {
                if (s.patchIDs[i] == first_ && points_[p] < 0)
                {
                    points_[p] = nColumns + more.size();
                    more.append(s.points[p]);
                }
            }
        }
        const label nMore = more.size();
        for (label i = 0; i < nMore; ++i)
        {
            images_.append(nColumns + nMore + i);
            more.append(more[i] + way);
        }
        mesh_.points.append(more);
    }

    //- isSecond: whether the face begins at the second point of the edge, as
    //  the second of two cyclic faces does
    face side(const edge& e, const bool isSecond = false) const
    {
        const face f({e[0], e[1], images_[e[1]], images_[e[0]]});

        return isSecond ? face(rotateList(f, -1)) : f;
    }

    void addTriangles()
    {
        const wallSurface& s = boundary_.surface;
        DynamicList<face> triangles(s.faces.size());
        forAll(s.faces, i)
        {
            if (s.patchIDs[i] == first_)
            {
                triangles.append(renumber(points_, s.faces[i]));
            }
        }
        triangles_.transfer(triangles);
        mesh_.nCells = triangles_.size();

        for (const face& f : triangles_)
        {
            if
            (
                orientation
                (
                    mesh_.points[f[0]], mesh_.points[f[1]], mesh_.points[f[2]],
                    mesh_.points[images_[f[0]]]
                ) <= 0
            )
            {
                refusePrism("not positive", f.centre(mesh_.points));
            }
        }
    }

    template<class Visit>
    void allSides(const Visit& visit) const
    {
        forAll(triangles_, c)
        {
            for (label k = 0; k < 3; ++k)
            {
                visit(c, edge(triangles_[c][k], triangles_[c].nextLabel(k)));
            }
        }
    }

    //- The internal faces, and the sides at the boundary
    void addSides()
    {
        EdgeMap<prismSide> single(triangles_.size());
        allSides([&](const label c, const edge& e)
        {
            const auto other = single.cfind(e);
            if (other.found())
            {
                const prismSide& owner = *other;
                faces_.append(side(owner.along), owner.cell, c);
                single.erase(e);
            }
            else
            {
                single.insert(e, prismSide{c, e});
            }
        });
        sortOpen(single);
    }

    //- Sides at the boundary are on the patch of the boundary's triangle beside
    //  the first plane; if there is none, on the layers
    void sortOpen(const EdgeMap<prismSide>& single)
    {
        const wallSurface& s = boundary_.surface;
        onPatches_.setSize(s.patchNames.size());
        EdgeMap<label> patches;
        forAll(s.faces, i)
        {
            const face& f = s.faces[i];
            for (label k = 0; s.patchIDs[i] != first_ && k < f.size(); ++k)
            {
                const edge e(points_[f[k]], points_[f.nextLabel(k)]);
                if (e[0] >= 0 && e[1] >= 0 && single.found(e))
                {
                    patches.insert(e, s.patchIDs[i]);
                }
            }
        }

        const EdgeMap<label> fronts(frontsInPlane(layers_, across_));
        allSides([&](const label c, const edge& e)
        {
            if (!single.found(e))
            {
                return;
            }
            if (patches.found(e))
            {
                onPatches_[patches[e]].append(prismSide{c, e});
            }
            else if (fronts.found(e))
            {
                onLayers_.append(std::make_pair(fronts[e], prismSide{c, e}));
            }
            else
            {
                refusePrism("behind the layers", e.centre(mesh_.points));
            }
        });
        std::sort
        (
            onLayers_.begin(), onLayers_.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; }
        );
    }

    //- Puts the sides on the second patch of each pair in the order of the
    //  first one
    void orderCyclic(const UList<sidePatch>& cyclicSides)
    {
        for (const sidePair& pair : pairsOf(cyclicSides))
        {
            const label first = patchOf(cyclicSides[pair.first].name);
            const label second = patchOf(cyclicSides[pair.second].name);
            isSecond_.insert(second);
            orderSidesAsImages
            (
                mesh_.points, pair.toSecond, onPatches_[first],
                onPatches_[second]
            );
        }
    }

    void addLayersPatch()
    {
        DynamicList<label> fronts(onLayers_.size());
        for (const auto& s : onLayers_)
        {
            fronts.append(s.first);
            faces_.append
            (
                side(s.second.along), s.second.cell, meshBuilder::onPatch(0)
            );
        }
        mesh_.frontFaces = fronts;
    }

    void addPatches()
    {
        const wallSurface& s = boundary_.surface;
        forAll(s.patchNames, patchi)
        {
            mesh_.patches.append(s.patchNames[patchi], s.patchTypes[patchi]);
            const label second = meshBuilder::onPatch(1 + patchi);
            for (const prismSide& open : onPatches_[patchi])
            {
                faces_.append
                (
                    side(open.along, isSecond_.found(patchi)), open.cell, second
                );
            }
            forAll(triangles_, c)
            {
                if (patchi == first_)
                {
                    faces_.append(triangles_[c].reverseFace(), c, second);
                }
                else if (patchi == second_)
                {
                    faces_.append(renumber(images_, triangles_[c]), c, second);
                }
            }
        }
    }

public:

    planarJoiner
    (
        const prismLayers& layers,
        const labelUList& across,
        const tetBoundary& boundary
    )
    :
        layers_(layers),
        across_(across),
        boundary_(boundary)
    {
        const labelPair empty(emptySides(layers.border));
        first_ = patchOf(layers.border.sides[empty.first()].name);
        second_ = patchOf(layers.border.sides[empty.second()].name);
    }

    farFieldMesh join(const UList<sidePatch>& cyclicSides)
    {
        addPoints();
        addTriangles();
        addSides();
        orderCyclic(cyclicSides);
        addLayersPatch();
        addPatches();
        const label nPatches = 1 + mesh_.patches.names.size();
        mesh_.topology = faces_.topology
        (
            faces_.order(mesh_.nCells, nPatches), nPatches
        );
        mesh_.cellZones.append
        (
            cellZoneParts(farFieldName, identity(mesh_.nCells))
        );

        return std::move(mesh_);
    }
};

} // End anonymous namespace


farFieldMesh makePlanarFarField
(
    const prismLayers& layers,
    const labelUList& across,
    const tetBoundary& boundary,
    const UList<sidePatch>& cyclicSides
)
{
    return planarJoiner(layers, across, boundary).join(cyclicSides);
}

} // End namespace Foam

// ************************************************************************* //
