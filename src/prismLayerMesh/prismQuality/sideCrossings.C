/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideCrossings.H"
#include "boundBox.H"
#include "labelledTriangle.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Triangles without those that are degenerate
static std::vector<labelledTriangle> withArea
(
    const faceList& triangles,
    const pointField& points,
    const labelList& faces
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


namespace
{

//- A side of a cell on a side patch
struct sideOnPatch
{
    point corners[4];
};


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
        return std::any_of
        (
            f.begin(), f.end(),
            [&](const label c) { return columns.found(c); }
        );
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


    //- The outer triangles of the faces of a list that are near to the part and
    //  do not touch it
    void takeOuter
    (
        const labelUList& faces,
        faceList& triangles,
        labelList& triangleFaces
    ) const
    {
        const boundBox bounds(side.points, false);

        for (const label facei : faces)
        {
            const face& f = layers.faces[facei];
            boundBox box(boundBox::invertedBox);
            for (const label c : f)
            {
                box.add(layers(c, layers.nLayers));
            }

            if (!bounds.overlaps(box) || touches(f))
            {
                continue;
            }

            for (label k = 1; k + 1 < f.size(); ++k)
            {
                triangles.append(face({f[0], f[k], f[k + 1]}));
                triangleFaces.append(facei);
            }
        }
    }


    //- Add the faces of a list whose outer faces intersect the part, or the
    //  sides of the layers, which are not quite on a curved part, but for those
    //  that touch it
    void addIntersecting
    (
        const labelUList& faces,
        const UList<sideOnPatch>& sides,
        labelHashSet& crossing
    ) const;
};


void sideColumns::addIntersecting
(
    const labelUList& faces,
    const UList<sideOnPatch>& sides,
    labelHashSet& crossing
) const
{
    faceList outer;
    labelList outerFaces;
    takeOuter(faces, outer, outerFaces);

    if (outer.empty())
    {
        return;
    }

    // One set of points: the outer ones, then those of the side patch
    pointField points(layers.outerPoints());
    const label nOuter = points.size();
    points.append(side.points);
    faceList triangles;
    for (const face& f : side.faces)
    {
        for (label k = 1; k + 1 < f.size(); ++k)
        {
            triangles.append
            (
                face({f[0] + nOuter, f[k] + nOuter, f[k + 1] + nOuter})
            );
        }
    }

    for (const sideOnPatch& s : sides)
    {
        const label p = points.size();
        points.append(UList<point>(const_cast<point*>(s.corners), 4));
        triangles.append(face({p, p + 1, p + 2}));
        triangles.append(face({p, p + 2, p + 3}));
    }

    DynamicList<labelPair> pairs;
    addIntersections
    (
        withArea(outer, points, outerFaces),
        withArea(triangles, points, labelList(triangles.size(), labelMax)),
        pairs
    );

    for (const labelPair& pair : pairs)
    {
        if (pair.second() == labelMax)
        {
            crossing.insert(pair.first());
        }
    }
}

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
            columns.addIntersecting
            (
                faces, sidesOn(layers, s, team), crossing
            );
        }
    }

    return crossing.sortedToc();
}

} // End namespace Foam

// ************************************************************************* //
