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

//- The box of some levels of a stack
static boundBox boundsOf
(
    const prismLayers& layers,
    const label facei,
    const label from,
    const label to
)
{
    boundBox bounds(boundBox::invertedBox);

    for (const label c : layers.faces[facei])
    {
        for (label i = from; i <= to; ++i)
        {
            bounds.add(layers(c, i));
        }
    }

    return bounds;
}


//- A point of a body that does not move: the middle of a face of the body's
//  wall. Points of the wall may be on a side patch, and so on the boundary of
//  other layers.
static point middleOf(const prismLayers& layers, const label facei)
{
    const face& f = layers.faces[facei];
    point middle(Zero);
    for (const label c : f)
    {
        middle += layers(c, 0)/f.size();
    }

    return middle;
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
    for (label i = 1; i <= layers.nLayers; ++i)
    {
        if (!boundsOf(layers, facei, i - 1, i).contains(x))
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

layerBodies findBodies(const prismLayers& layers)
{
    disjointSets columns(connectedPoints(layers.nColumns(), layers.faces));
    Map<label> bodyOfColumn;
    layerBodies bodies;
    bodies.ofFaces.setSize(layers.faces.size());
    DynamicList<label> firstFaces;

    forAll(layers.faces, facei)
    {
        const label c = columns.find(layers.faces[facei][0]);
        if (bodyOfColumn.insert(c, firstFaces.size()))
        {
            firstFaces.append(facei);
        }
        bodies.ofFaces[facei] = bodyOfColumn[c];
    }
    bodies.firstFaces = std::move(firstFaces);

    return bodies;
}


List<labelPair> findNestedBodies
(
    const prismLayers& layers,
    const labelUList& stacks,
    const layerBodies& bodies
)
{
    const label nBodies = bodies.firstFaces.size();
    DynamicList<labelPair> pairs;

    if (nBodies == 1)
    {
        return List<labelPair>();
    }

    // In ascending order of x
    scalarField x(nBodies);
    pointField middles(nBodies);
    forAll(middles, i)
    {
        middles[i] = middleOf(layers, bodies.firstFaces[i]);
        x[i] = middles[i].x();
    }
    const labelList order(sortedOrder(x));
    x = scalarField(x, order);

    #pragma omp parallel for schedule(dynamic, 64) if (stacks.size() > 128)
    forAll(stacks, k)
    {
        const label facei = stacks[k];
        const boundBox box(boundsOf(layers, facei, 0, layers.nLayers));
        label i =
            std::lower_bound(x.begin(), x.end(), box.min().x()) - x.begin();

        for (; i < nBodies && x[i] <= box.max().x(); ++i)
        {
            const label body = order[i];

            if
            (
                body != bodies.ofFaces[facei]
             && box.contains(middles[body])
             && isInStack(layers, facei, middles[body])
            )
            {
                #pragma omp critical
                pairs.append
                (
                    labelPair
                    (
                        bodies.firstFaces[body], layers.faces.size() + facei
                    )
                );
            }
        }
    }
    sort(pairs);

    return List<labelPair>(std::move(pairs));
}

} // End namespace Foam

// ************************************************************************* //
