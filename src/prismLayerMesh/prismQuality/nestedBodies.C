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


namespace
{

struct firstFace
{
    label facei;
    point middle;
};

}


//- Returns for each column the first front face, in the whole front, of the
//  body that the column is on
static labelList firstFacesOfColumns
(
    const prismLayers& layers,
    const columnTeam& team
)
{
    disjointSets parts(connectedPoints(layers.nColumns(), layers.faces));
    labelList ofParts(layers.nColumns(), labelMax);
    forAll(layers.faces, facei)
    {
        label& first = ofParts[parts.find(layers.faces[facei][0])];
        first = min(first, team.wholeFace(facei));
    }

    // A body may have a part on each share
    labelList ofColumns(layers.nColumns(), labelMax);
    do
    {
        forAll(ofColumns, c)
        {
            label& first = ofParts[parts.find(c)];
            first = min(first, ofColumns[c]);
        }
        forAll(ofColumns, c)
        {
            ofColumns[c] = ofParts[parts.find(c)];
        }
    }
    while (team.columns.lower(ofColumns));

    return ofColumns;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

layerBodies findBodies(const prismLayers& layers, const columnTeam& team)
{
    const labelList first(firstFacesOfColumns(layers, team));
    DynamicList<firstFace> own;
    forAll(layers.faces, facei)
    {
        const face& f = layers.faces[facei];
        if (first[f[0]] == team.wholeFace(facei) && team.counts(f))
        {
            own.append({first[f[0]], middleOf(layers, facei)});
        }
    }

    List<firstFace> all(team.gather(own));
    std::sort
    (
        all.begin(), all.end(),
        [](const firstFace& a, const firstFace& b) { return a.facei < b.facei; }
    );

    layerBodies bodies;
    bodies.firstFaces.setSize(all.size());
    bodies.middles.setSize(all.size());
    forAll(all, i)
    {
        bodies.firstFaces[i] = all[i].facei;
        bodies.middles[i] = all[i].middle;
    }
    bodies.ofFaces.setSize(layers.faces.size());
    forAll(layers.faces, facei)
    {
        bodies.ofFaces[facei] = std::lower_bound
        (
            bodies.firstFaces.begin(), bodies.firstFaces.end(),
            first[layers.faces[facei][0]]
        ) - bodies.firstFaces.begin();
    }

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
    const pointField& middles = bodies.middles;
    scalarField x(middles.component(vector::X));
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
