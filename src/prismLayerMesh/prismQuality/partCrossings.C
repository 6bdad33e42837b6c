/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partCrossings.H"
#include "HashSet.H"
#include "labelledTriangle.H"
#include "stackBoxes.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
        if (border.edgeSides[i] == s && team.counts(labelList(e)))
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList facesThroughPart
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
        addFan(layers.faces[facei], 0, outer);
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

} // End namespace Foam

// ************************************************************************* //
