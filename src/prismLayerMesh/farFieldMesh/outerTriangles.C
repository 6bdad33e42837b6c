/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "outerTriangles.H"
#include "labelledTriangle.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Six times the volume between the fan from corner k of a face and its fan
//  from corner 0
static scalar volumeBelow
(
    const pointField& points,
    const face& f,
    const label k
)
{
    const label n = f.size();
    const point& origin = points[f[0]];
    const vector apex(points[f[k]] - origin);
    scalar volume = 0;

    for (label i = 1; i + 1 < n; ++i)
    {
        const vector a(points[f[(k + i) % n]] - origin);
        const vector b(points[f[(k + i + 1) % n]] - origin);
        volume += apex & (a ^ b);
    }

    return volume;
}


//- The corner whose fan is the highest
static label highestFan(const pointField& points, const face& f)
{
    label highest = 0;

    for (label k = 1; f.size() > 3 && k < f.size(); ++k)
    {
        if (volumeBelow(points, f, k) > volumeBelow(points, f, highest))
        {
            highest = k;
        }
    }

    return highest;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

faceList outerTriangles(const wallSurface& outer, labelList& triangleFace)
{
    wallSurface cut(outer);
    boolList changed(outer.faces.size(), false);

    forAll(cut.faces, facei)
    {
        const label k = highestFan(outer.points, outer.faces[facei]);
        changed[facei] = k > 0;
        cut.faces[facei] = rotateList(outer.faces[facei], -k);
    }

    faceList triangles(wallTriangles(cut, triangleFace));

    // Without changes there are no intersections
    while (changed.found(true))
    {
        DynamicList<labelPair> pairs;
        addIntersections
        (
            labelledTriangles(triangles, cut.points, triangleFace), {}, pairs
        );

        if (pairs.empty())
        {
            break;
        }

        for (const labelPair& pair : pairs)
        {
            for (const label facei : pair)
            {
                changed[facei] = false;
                cut.faces[facei] = outer.faces[facei];
            }
        }

        triangles = wallTriangles(cut, triangleFace);
    }

    return triangles;
}


point pointBelow(const face& triangle, const prismLayers& layers)
{
    const label n = layers.nLayers;
    const point& a = layers(triangle[0], n);
    const point& b = layers(triangle[1], n);
    const point& c = layers(triangle[2], n);
    const vector normal((b - a) ^ (c - a));
    scalar highest = -GREAT;
    point below(a);

    for (const label column : triangle)
    {
        const point& x = layers(column, n - 1);
        const scalar height = (layers(column, n) - x) & normal;
        if (height > highest)
        {
            highest = height;
            below = x;
        }
    }

    return 0.25*(a + b + c + below);
}

} // End namespace Foam

// ************************************************************************* //
