/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetBoundary.H"
#include "labelledTriangle.H"
#include "ListOps.H"
#include "prismQuality.H"
#include "refineSurface.H"
#include "sidePatchRemainders.H"
#include "sideShape.H"
#include "surfacePart.H"

#include <algorithm>

namespace Foam
{

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


//- A point is close behind a triangle if it is so many times the square root
//  of twice the area away
static constexpr scalar behindShare = 1e-6;


point pointBelow(const face& triangle, const prismLayers& layers)
{
    const label n = layers.nLayers;
    const point& a = layers(triangle[0], n);
    const point& b = layers(triangle[1], n);
    const point& c = layers(triangle[2], n);
    const vector normal((b - a) ^ (c - a));
    if (n == 0)
    {
        return
            triangle.centre(layers.points)
          - behindShare*normal/sqrt(max(mag(normal), VSMALL));
    }
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


// * * * * * * * * * * * * * * *  Tet Boundary * * * * * * * * * * * * * * * //

//- Puts the points whose triangles are of one curved side patch, or of sectors
//  of one, on it; not those of the layers. Then merges patches of one name.
static void putOnSides
(
    const UList<sidePatch>& sides,
    const farFieldBoundary& coarse,
    wallSurface& far
)
{
    labelList patches(far.points.size(), -1);
    bitSet onSeveral(far.points.size());
    forAll(far.faces, facei)
    {
        const label patchi = far.patchIDs[facei];

        for (const label p : far.faces[facei])
        {
            const label other = patches[p];
            if (other >= 0 && far.patchNames[other] != far.patchNames[patchi])
            {
                onSeveral.set(p);
            }
            patches[p] = patchi;
        }
    }

    for (label p = coarse.columns.size(); p < far.points.size(); ++p)
    {
        const label s = patches[p] - coarse.firstSide;

        if (s >= 0 && sides[s].isCurved() && !onSeveral.test(p))
        {
            far.points[p] = sides[s].shape->nearest(far.points[p]).rawPoint();
        }
    }

    // In the order of the far boundary's patches: some of them are sides
    for (label& patchi : far.patchIDs)
    {
        patchi = far.patchNames.find(far.patchNames[patchi]);
    }
    mergePatches(far);
}


tetBoundary makeTetBoundary
(
    const prismLayers& layers,
    const farBoundary& boundary,
    const std::function<scalar(const point&)>& size
)
{
    tetBoundary result;

    if (layers.border.sides.empty())
    {
        result.surface = boundary.surface;
        result.surface.patchTypes = boundary.patchTypes;
        refineSurface
        (
            result.surface, size, boundary.project, boundary.cyclicSides
        );

        return result;
    }

    farBoundary far(boundary);
    if (far.project)
    {
        refineSurface(far.surface, size, far.project);
    }
    const farFieldBoundary coarse(makeFarFieldBoundary(layers, far, size));
    result.columns = coarse.columns;
    result.surface = coarse.surface;
    refineSurface
    (
        result.surface, size, nullptr, boundary.cyclicSides,
        coarse.columns.size()
    );
    putOnSides(layers.border.sides, coarse, result.surface);

    return result;
}


tetBoundary makePlaneBoundary
(
    const prismLayers& layers,
    const coreCut& cut,
    const meshPatches& patches,
    const UList<sidePatch>& cyclicSides,
    const std::function<scalar(const point&)>& size
)
{
    const farFieldBoundary remainders(makePlaneRemainders(layers, cut, size));
    tetBoundary result;
    result.columns = remainders.columns;

    // Better triangles, of the points that are used, then with all points
    const label nKept = remainders.columns.size() + cut.surface.points.size();
    surfacePart planes
    (
        makeSurfacePart
        (
            remainders.surface, identity(remainders.surface.faces.size())
        )
    );
    const label nUsed = std::lower_bound
    (
        planes.points.begin(), planes.points.end(), nKept
    ) - planes.points.begin();
    refineSurface(planes.surface, size, nullptr, cyclicSides, nUsed);
    result.surface.points = SubList<point>(remainders.surface.points, nKept);
    appendSurface
    (
        planes.surface, SubList<label>(planes.points, nUsed), result.surface
    );

    // By the names of the core's patches
    for (label& patchi : result.surface.patchIDs)
    {
        patchi = patches.names.find(remainders.surface.patchNames[patchi]);
    }
    result.surface.patchNames.clear();
    result.surface.patchTypes.clear();
    result.nCutPoints = cut.surface.points.size();

    return result;
}


void addCut
(
    const coreCut& cut,
    const meshPatches& patches,
    tetBoundary& boundary
)
{
    wallSurface& surface = boundary.surface;
    const label first = boundary.nCutPoints
      ? boundary.columns.size() : surface.points.size();
    appendSurface(cut.surface, identity(boundary.nCutPoints, first), surface);
    surface.patchNames.append(patches.names);
    surface.patchTypes.append(patches.types());
    boundary.corePoints = labelList(surface.points.size(), -1);
    SubList<label>(boundary.corePoints, cut.points.size(), first) = cut.points;

    boundary.cutFaces = cut.cutFaces;
    boundary.cutCells = cut.cutCells;
    boundary.seeds = cut.seeds;

    // Triangles use all points of columns
    const labelList newLabels
    (
        removeUnusedPoints(surface.faces, surface.points)
    );
    inplaceReorder(newLabels, boundary.corePoints, true);
}


wallSurface joined(const wallSurface& outer, const tetBoundary& boundary)
{
    wallSurface both(outer);
    appendSurface(boundary.surface, boundary.columns, both);

    return both;
}

} // End namespace Foam

// ************************************************************************* //
