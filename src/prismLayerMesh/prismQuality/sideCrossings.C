/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideCrossings.H"
#include "HashSet.H"
#include "labelledTriangle.H"
#include "layerOverlaps.H"
#include "ListOps.H"
#include "prismQuality.H"
#include "ranges.H"

#include <algorithm>

namespace Foam
{

namespace
{

//- A side of a cell on a side patch
struct sideOnPatch
{
    point corners[4];
};

} // End anonymous namespace


//- The sides of the layers of all processes on a side patch, if it is curved
static List<sideOnPatch> sidesOn
(
    const prismLayers& layers,
    const label s,
    const columnTeam& team
)
{
    const wallBorder& border = layers.border;
    DynamicList<sideOnPatch> sides;

    if (!border.sides[s].isCurved())
    {
        return List<sideOnPatch>();
    }

    forAll(border.edges, i)
    {
        const edge& e = border.edges[i];
        if (border.edgeSides[i] == s && team.countsEdge(e))
        {
            for (label level = 0; level < layers.nLayers; ++level)
            {
                sides.append
                ({{
                    layers(e.start(), level), layers(e.end(), level),
                    layers(e.end(), level + 1), layers(e.start(), level + 1)
                }});
            }
        }
    }

    return team.gather(sides);
}


//- Triangles without those that are degenerate
static std::vector<labelledTriangle> withArea
(
    const UList<face>& triangles,
    const pointField& points,
    const labelUList& faces
)
{
    std::vector<labelledTriangle> all
    (
        labelledTriangles(triangles, points, faces)
    );
    all.erase
    (
        std::remove_if
        (
            all.begin(), all.end(),
            [](const labelledTriangle& t) { return t.degenerate(); }
        ),
        all.end()
    );

    return all;
}


//- Adds the triangles of a face, a fan from its first point.
//  first: label of the points' point 0
static void addFan
(
    const face& f,
    const label first,
    DynamicList<face>& triangles
)
{
    for (label k = 1; k + 1 < f.size(); ++k)
    {
        triangles.append
        (
            face({first + f[0], first + f[k], first + f[k + 1]})
        );
    }
}


//- The front faces of a list whose outer faces are near to a side patch
static labelList facesNear
(
    const prismLayers& layers,
    const sidePatch& side,
    const labelUList& faces
)
{
    const boundBox bounds(side.points, false);

    return subsetList(faces, [&](const label facei)
    {
        return bounds.overlaps(boxOf(layers, facei, layers.nLayers));
    });
}


//- Returns the front faces of a list whose outer faces intersect a side patch
//  that is a part. On a curved part the sides of the layers of all processes,
//  which are not quite on the part, count as parts of the side patch.
//  Collective.
//  s: index of the side patch in the border of the layers
//  faces: front faces without columns on the side patch
static labelList facesThroughPart
(
    const prismLayers& layers,
    const label s,
    const labelUList& faces,
    const columnTeam& team
)
{
    const List<sideOnPatch> sides(sidesOn(layers, s, team));
    const sidePatch& side = layers.border.sides[s];
    const labelList near(facesNear(layers, side, faces));
    if (near.empty())
    {
        return labelList();
    }

    // One set of points: the outer ones, then those of the side patch
    pointField points(layers.outerPoints());
    DynamicList<face> outer, part;
    DynamicList<label> outerFaces;
    for (const label facei : near)
    {
        addFan(outerFan(layers, facei), 0, outer);
        outerFaces.resize(outer.size(), facei);
    }
    const label nOuter = points.size();
    points.append(side.points);
    for (const face& f : side.faces)
    {
        addFan(f, nOuter, part);
    }
    for (const sideOnPatch& onPatch : sides)
    {
        addFan(face({0, 1, 2, 3}), points.size(), part);
        points.append(UList<point>(const_cast<point*>(onPatch.corners), 4));
    }

    DynamicList<labelPair> pairs;
    addIntersections
    (
        withArea(outer, points, outerFaces),
        withArea(part, points, labelList(part.size(), labelMax)),
        pairs
    );

    labelHashSet crossing;
    for (const labelPair& pair : pairs)
    {
        if (pair.second() == labelMax)
        {
            crossing.insert(pair.first());
        }
    }

    return crossing.sortedToc();
}


// * * * * * * * * * * * * * *  Side Crossings * * * * * * * * * * * * * * * //

namespace
{

//- A side patch and the columns that stand on it
struct sideColumns
{
    const prismLayers& layers;
    const sidePatch& side;
    labelHashSet columns;

    //- A side patch of each column on one
    const Map<label>& sideOf;

    sideColumns(const prismLayers& l, const label s, const Map<label>& of)
    :
        layers(l),
        side(l.border.sides[s]),
        sideOf(of)
    {
        forAll(layers.border.edges, i)
        {
            if (layers.border.edgeSides[i] == s)
            {
                columns.insert(layers.border.edges[i]);
            }
        }
    }


    bool touches(const face& f) const
    {
        return anyOf(f, [&](const label c) { return columns.found(c); });
    }


    //- Whether a point of a column is on a side patch that continues this one
    bool isContinued(const label c, const point& x) const
    {
        const auto other = sideOf.cfind(c);

        return other.found() && side.isCurved()
            && (
                   side.planeAt(x).normal
                 & layers.border.sides[*other].planeAt(x).normal
               ) > curvedCosine;
    }


    //- Whether a stack has points that are not in front of the side patch, but
    //  for the columns on it, and those that begin beyond its plane: on a side
    //  patch with a reflex angle to it
    bool isBeyond(const face& f) const
    {
        for (const label c : f)
        {
            if (columns.found(c) || side.distance(layers(c, 0)) >= 0)
            {
                continue;
            }

            for (label i = 1; i <= layers.nLayers; ++i)
            {
                const point& x = layers(c, i);

                if (side.distance(x) >= 0 && !isContinued(c, x))
                {
                    return true;
                }
            }
        }

        return false;
    }
};

} // End anonymous namespace


labelList findSideCrossings
(
    const prismLayers& layers,
    const labelUList& faces,
    const columnTeam& team
)
{
    labelHashSet crossing;
    Map<label> sideOf;
    forAll(layers.border.edges, i)
    {
        const edge& e = layers.border.edges[i];
        sideOf.set(e.start(), layers.border.edgeSides[i]);
        sideOf.set(e.end(), layers.border.edgeSides[i]);
    }

    forAll(layers.border.sides, s)
    {
        const sideColumns columns(layers, s, sideOf);
        const bool isPart = columns.side.isPart();

        for (const label facei : faces)
        {
            const face& f = layers.faces[facei];

            if ((!isPart || columns.touches(f)) && columns.isBeyond(f))
            {
                crossing.insert(facei);
            }
        }

        if (isPart)
        {
            const auto isApart = [&](const label facei)
            {
                return !columns.touches(layers.faces[facei]);
            };
            crossing.insert
            (
                facesThroughPart(layers, s, subsetList(faces, isApart), team)
            );
        }
    }

    return crossing.sortedToc();
}

} // End namespace Foam

// ************************************************************************* //
