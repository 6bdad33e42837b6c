/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/


#include "testLayers.H"
#include "DynamicList.H"
#include "Random.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The different normals at each point
static List<DynamicList<vector>> pointNormals(const wallSurface& wall)
{
    List<DynamicList<vector>> normals(wall.points.size());

    for (const face& f : wall.faces)
    {
        const vector n(normalised(f.areaNormal(wall.points)));

        for (const label p : f)
        {
            bool known = false;
            for (const vector& other : normals[p])
            {
                known = known || mag(n - other) < 1e-9;
            }

            if (!known)
            {
                normals[p].append(n);
            }
        }
    }

    return normals;
}


//- The vector along the mean normal, of unit length normal to the faces
static vector columnVector(const UList<vector>& normals)
{
    vector mean(Zero);
    for (const vector& n : normals)
    {
        mean += n;
    }

    scalar projection = GREAT;
    for (const vector& n : normals)
    {
        projection = min(projection, mean & n);
    }

    return mean/projection;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::prismLayers Foam::testSurfaces::straightLayers
(
    const wallSurface& wall,
    const scalarList& heights
)
{
    prismLayers layers;
    layers.nLayers = heights.size() - 1;
    layers.faces = wall.faces;
    layers.patchIDs = wall.patchIDs;
    layers.patchNames = wall.patchNames;
    layers.points.setSize(wall.points.size()*heights.size());

    const List<DynamicList<vector>> normals(pointNormals(wall));

    forAll(wall.points, p)
    {
        const vector column(columnVector(normals[p]));

        forAll(heights, i)
        {
            layers.points[layers.pointLabel(p, i)] =
                wall.points[p] + heights[i]*column;
        }
    }

    return layers;
}


Foam::prismLayers Foam::testSurfaces::frontLayers
(
    const layerFront& front,
    const scalarList& heights
)
{
    prismLayers layers;
    layers.nLayers = heights.size() - 1;
    layers.faces = front.surface.faces;
    layers.patchIDs = SubList<label>(front.surface.patchIDs, front.nWallFaces);
    layers.patchNames = front.surface.patchNames;
    layers.extraColumnPoints = front.extraColumnPoints();
    layers.points.setSize(front.wallPoints.size()*heights.size());

    forAll(front.wallPoints, c)
    {
        forAll(heights, i)
        {
            layers.points[layers.index(c, i)] = front.surface.points[c]
              + heights[i]*front.visibility.cones[c].axis;
        }
    }

    return layers;
}


Foam::layerFront Foam::testSurfaces::frontOf
(
    const wallSurface& wall,
    const scalar smallestAngle
)
{
    const wallAddressing addressing(makeWallAddressing(wall));
    const wallVisibility visibility(makeWallVisibility(wall, addressing));
    layerFront front
    (
        makeBareFront(wall, addressing, visibility, degToRad(smallestAngle))
    );
    front.complete(addressing, visibility);

    return front;
}


Foam::prismLayers Foam::testSurfaces::onePolygon
(
    const label nPoints,
    const scalarList& heights
)
{
    wallSurface wall;
    wall.patchIDs = labelList(1, Zero);
    wall.patchNames = wordList(1, word("wall"));
    wall.faces.setSize(1);
    wall.faces[0].setSize(nPoints);

    for (label k = 0; k < nPoints; ++k)
    {
        const scalar angle = degToRad(360.0*k/nPoints);
        wall.faces[0][k] = k;
        wall.points.append(point(cos(angle), sin(angle), 0));
    }

    return straightLayers(wall, heights);
}


Foam::prismLayers Foam::testSurfaces::shakenLayers
(
    const wallSurface& wall,
    const scalar by
)
{
    prismLayers layers
    (
        straightLayers(wall, geometricHeights(nShaken, 0.05, 1.2))
    );

    Random random(5);
    for (point& p : layers.points)
    {
        p += by*(random.sample01<vector>() - vector::uniform(0.5));
    }

    return layers;
}


Foam::scalarList Foam::testSurfaces::geometricHeights
(
    const label n,
    const scalar first,
    const scalar ratio
)
{
    scalarList heights(n + 1, Zero);

    for (label i = 1; i <= n; ++i)
    {
        heights[i] = heights[i - 1] + first*pow(ratio, i - 1);
    }

    return heights;
}


// ************************************************************************* //
