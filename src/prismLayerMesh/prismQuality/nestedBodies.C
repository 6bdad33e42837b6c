/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nestedBodies.H"
#include "orientation.H"
#include "disjointSets.H"
#include "prismQuality.H"
#include "boundBox.H"
#include "DynamicList.H"
#include "Map.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A body: a component of the front
struct frontBody
{
    labelList faces;

    //- Of its layers
    boundBox bounds;

    //- The middle of one of its cells: points of the wall may be on a side
    //  patch, and so on the boundary of other layers
    point inside;
};


static boundBox boundsOf
(
    const prismLayers& layers,
    const labelUList& faces,
    const label from,
    const label to
)
{
    boundBox bounds(boundBox::invertedBox);

    for (const label facei : faces)
    {
        for (const label c : layers.faces[facei])
        {
            for (label i = from; i <= to; ++i)
            {
                bounds.add(layers(c, i));
            }
        }
    }

    return bounds;
}


//- None if there is only one
static List<frontBody> findBodies(const prismLayers& layers)
{
    disjointSets columns(layers.nColumns());

    for (const face& f : layers.faces)
    {
        for (const label c : f)
        {
            columns.join(f[0], c);
        }
    }

    const label first = columns.find(layers.faces[0][0]);
    const bool isOne = std::all_of
    (
        layers.faces.begin(), layers.faces.end(),
        [&](const face& f) { return columns.find(f[0]) == first; }
    );
    if (isOne)
    {
        return List<frontBody>();
    }

    Map<DynamicList<label>> faces;

    forAll(layers.faces, facei)
    {
        faces(columns.find(layers.faces[facei][0])).append(facei);
    }

    List<frontBody> bodies(faces.size());
    label bodyi = 0;

    for (const label column : faces.sortedToc())
    {
        frontBody& body = bodies[bodyi++];
        body.faces = faces[column];

        const face& f = layers.faces[body.faces[0]];
        body.inside = Zero;
        for (const label c : f)
        {
            body.inside += (layers(c, 0) + layers(c, 1))/(2*f.size());
        }
    }

    for (frontBody& body : bodies)
    {
        body.bounds = boundsOf(layers, body.faces, 0, layers.nLayers);
    }

    return bodies;
}


//- Exact; not in tetrahedra without volume
static bool isInTet(const FixedList<point, 4>& tet, const point& x)
{
    const int sign = orientation(tet[0], tet[1], tet[2], tet[3]);

    return sign
     && sign*orientation(x, tet[1], tet[2], tet[3]) >= 0
     && sign*orientation(tet[0], x, tet[2], tet[3]) >= 0
     && sign*orientation(tet[0], tet[1], x, tet[3]) >= 0
     && sign*orientation(tet[0], tet[1], tet[2], x) >= 0;
}


//- Whether x is in the convex hull: in a tetrahedron of four of the points
static bool isInHull(const UList<point>& points, const point& x)
{
    const label n = points.size();

    for (label a = 0; a < n; ++a)
    {
        for (label b = a + 1; b < n; ++b)
        {
            for (label c = b + 1; c < n; ++c)
            {
                for (label d = c + 1; d < n; ++d)
                {
                    if
                    (
                        isInTet({points[a], points[b], points[c], points[d]}, x)
                    )
                    {
                        return true;
                    }
                }
            }
        }
    }

    return false;
}


static bool isInStack
(
    const prismLayers& layers,
    const label facei,
    const point& x
)
{
    const labelList single(1, facei);

    if (!boundsOf(layers, single, 0, layers.nLayers).contains(x))
    {
        return false;
    }

    for (label i = 1; i <= layers.nLayers; ++i)
    {
        if (!boundsOf(layers, single, i - 1, i).contains(x))
        {
            continue;
        }

        // Of polygons the fans that their surfaces are cut into: warped ones
        // have a hull at any thickness
        const face& f = layers.faces[facei];

        for (label k = 1; k + 1 < f.size(); ++k)
        {
            DynamicList<point> points;
            for (const label c : {f[0], f[k], f[k + 1]})
            {
                points.append(layers(c, i - 1));
                points.append(layers(c, i));
            }

            if (isInHull(points, x))
            {
                return true;
            }
        }
    }

    return false;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<labelPair> findNestedBodies(const prismLayers& layers)
{
    const List<frontBody> bodies(findBodies(layers));
    DynamicList<labelPair> pairs;

    forAll(bodies, i)
    {
        forAll(bodies, j)
        {
            if (i == j || !bodies[j].bounds.contains(bodies[i].inside))
            {
                continue;
            }

            for (const label facei : bodies[j].faces)
            {
                if (isInStack(layers, facei, bodies[i].inside))
                {
                    pairs.append
                    (
                        labelPair
                        (
                            bodies[i].faces[0], layers.faces.size() + facei
                        )
                    );
                }
            }
        }
    }

    return List<labelPair>(std::move(pairs));
}

} // End namespace Foam

// ************************************************************************* //
