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

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


//- The middle of one of a body's cells: points of the wall may be on a side
//  patch, and so on the boundary of other layers
static point pointInside(const prismLayers& layers, const labelUList& body)
{
    const face& f = layers.faces[body[0]];
    point inside(Zero);
    for (const label c : f)
    {
        inside += (layers(c, 0) + layers(c, 1))/(2*f.size());
    }

    return inside;
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

labelListList findBodies(const prismLayers& layers)
{
    disjointSets columns(connectedPoints(layers.nColumns(), layers.faces));
    Map<DynamicList<label>> faces;
    forAll(layers.faces, facei)
    {
        faces(columns.find(layers.faces[facei][0])).append(facei);
    }

    DynamicList<labelList> bodies;
    if (faces.size() > 1)
    {
        for (const label column : faces.sortedToc())
        {
            bodies.append(labelList(std::move(faces[column])));
        }
    }

    return labelListList(std::move(bodies));
}


List<labelPair> findNestedBodies
(
    const prismLayers& layers,
    const labelListList& bodies
)
{
    List<boundBox> bounds(bodies.size());
    forAll(bodies, i)
    {
        bounds[i] = boundsOf(layers, bodies[i], 0, layers.nLayers);
    }

    DynamicList<labelPair> pairs;
    forAll(bodies, i)
    {
        const point inside(pointInside(layers, bodies[i]));

        forAll(bodies, j)
        {
            if (i == j || !bounds[j].contains(inside))
            {
                continue;
            }

            for (const label facei : bodies[j])
            {
                if (isInStack(layers, facei, inside))
                {
                    pairs.append
                    (
                        labelPair(bodies[i][0], layers.faces.size() + facei)
                    );
                }
            }
        }
    }

    return List<labelPair>(std::move(pairs));
}

} // End namespace Foam

// ************************************************************************* //
