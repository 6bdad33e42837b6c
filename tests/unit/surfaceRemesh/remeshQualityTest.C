/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshSurface.H"
#include "edgeHashes.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A column of 1 m by 1 m, without points on its edges of 100 m
static wallSurface column()
{
    wallSurface surface(cube(1));
    for (point& x : surface.points)
    {
        x.z() *= 100;
    }

    return surface;
}


//- Along the axes
static edgeList straightEdges(const wallSurface& surface)
{
    edgeHashSet edges;
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            const vector d(e.vec(surface.points));
            if (cmptMag(d) == vector(mag(d.x()), 0, 0)
             || cmptMag(d) == vector(0, mag(d.y()), 0)
             || cmptMag(d) == vector(0, 0, mag(d.z())))
            {
                edges.insert(e);
            }
        }
    }

    return edges.sortedToc();
}


//- Two triangles in a plane: the angle at the first point, halved by the edge
//  between them, is that of the borders
static wallSurface tip(const scalar halfWidth)
{
    wallSurface surface;
    surface.points =
        pointField({Zero, {1, -halfWidth, 0}, {1.1, 0, 0}, {1, halfWidth, 0}});
    surface.faces = faceList({face({0, 1, 2}), face({0, 2, 3})});
    surface.patchIDs = labelList(2, 0);

    return surface;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(remeshQuality, needlesBetweenFeaturesThatEdgesResolveCount)
{
    const remeshQuality quality
    (
        qualityAwayFromFeatures(column(), straightEdges(column()), 0.1)
    );

    // Two triangles of each side, and the diagonals between them
    EXPECT_EQ(quality.nSmallAngles, 8);
    EXPECT_EQ(quality.nNonOrtho, 4);
}


TEST(remeshQuality, featuresNearerThanEdgesDoNotCount)
{
    const remeshQuality quality
    (
        qualityAwayFromFeatures(column(), straightEdges(column()), 5)
    );

    EXPECT_EQ(quality.nSmallAngles, 0);
    EXPECT_EQ(quality.nNonOrtho, 0);
}


TEST(remeshQuality, anglesBetweenTwoFeaturesDoNotCount)
{
    const edgeList borders({{0, 1}, {1, 2}, {2, 3}, {0, 3}});
    wallSurface one(tip(0.1));
    one.faces = faceList({face({0, 1, 3}), face({1, 2, 3})});

    // 11 degrees between the borders, 45 in the other triangle
    const remeshQuality quality
    (
        qualityAwayFromFeatures(one, borders, 0.01)
    );
    EXPECT_EQ(quality.nSmallAngles, 0);
    EXPECT_EQ(quality.nNonOrtho, 0);

    // Each half of them is beside an edge that is no feature
    EXPECT_EQ
    (
        qualityAwayFromFeatures(tip(0.1), borders, 0.01).nSmallAngles, 2
    );
}


TEST(remeshQuality, regularFacesCountNothing)
{
    const remeshQuality quality
    (
        qualityAwayFromFeatures(sphere(8), edgeList(), 0.01)
    );

    EXPECT_EQ(quality.nSmallAngles, 0);
    EXPECT_EQ(quality.nNonOrtho, 0);
}


// ************************************************************************* //
