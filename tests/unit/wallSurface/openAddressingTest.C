/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"

#include <gtest/gtest.h>

#include <algorithm>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether a face runs from a point to another
static bool runsAlong(const face& f, const label a, const label b)
{
    const label k = f.find(a);

    return k >= 0 && f.nextLabel(k) == b;
}


static List<wallSurface> walls()
{
    return List<wallSurface>
    ({
        endedOn(halfCube(4), halfPlanes()),
        endedOn(quarterCube(4), quarterPlanes()),
        endedOn(halfSphere(6), halfPlanes()),
        endedOn(duct(3), wordList({"inlet", "outlet"}))
    });
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(openAddressing, fansGoFromBorderToBorder)
{
    for (const wallSurface& wall : walls())
    {
        const wallAddressing a(makeWallAddressing(wall));
        const Map<labelPair> border(wall.border.pointSides());

        forAll(wall.points, p)
        {
            const labelList& faces = a.pointFaces[p];
            const labelList& points = a.pointPoints[p];
            const bool onBorder = border.found(p);
            ASSERT_EQ(points.size(), faces.size() + onBorder);

            forAll(faces, i)
            {
                const label last =
                    onBorder ? points[i + 1] : points[points.fcIndex(i)];
                EXPECT_TRUE(runsAlong(wall.faces[faces[i]], p, points[i]));
                EXPECT_TRUE(runsAlong(wall.faces[faces[i]], last, p));
            }
        }
    }
}


TEST(openAddressing, edgesOfTheBorderHaveOneFace)
{
    for (const wallSurface& wall : walls())
    {
        const wallAddressing a(makeWallAddressing(wall));
        label nOpen = 0;

        forAll(a.edges, e)
        {
            const bool open = a.edgeFaces[e].second() < 0;
            nOpen += open;
            EXPECT_TRUE
            (
                runsAlong
                (
                    wall.faces[a.edgeFaces[e].first()],
                    a.edges[e].start(), a.edges[e].end()
                )
            );
            EXPECT_EQ(open, wall.border.edges.found(a.edges[e]));
        }

        EXPECT_EQ(nOpen, wall.border.edges.size());
    }
}


TEST(openAddressing, cornersAreOnTwoSides)
{
    const wallSurface wall(endedOn(quarterCube(4), quarterPlanes()));
    const wallAddressing a(makeWallAddressing(wall));

    forAll(wall.points, p)
    {
        const point& x = wall.points[p];
        labelList expected;
        if (x.z() == 0)
        {
            expected.append(0);
        }
        if (x.y() == 0)
        {
            expected.append(1);
        }

        labelList sides(a.sidesOf(p));
        std::sort(sides.begin(), sides.end());
        EXPECT_EQ(sides, expected);
    }
}


TEST(openAddressing, firstAndLastEdgesAreOnTheirSides)
{
    for (const wallSurface& wall : walls())
    {
        const wallAddressing a(makeWallAddressing(wall));

        forAll(wall.border.edges, i)
        {
            const edge& e = wall.border.edges[i];
            EXPECT_EQ(a.pointPoints[e.start()][0], e.end());
            EXPECT_EQ(a.pointPoints[e.end()].last(), e.start());
            EXPECT_EQ
            (
                a.pointSides[e.start()].first(), wall.border.edgeSides[i]
            );
            EXPECT_EQ
            (
                a.pointSides[e.end()].second(), wall.border.edgeSides[i]
            );
        }
    }
}


TEST(openAddressing, closedWallsHaveNoSides)
{
    const wallAddressing a(makeWallAddressing(quadCube(3)));

    EXPECT_TRUE(a.pointSides.empty());
    EXPECT_TRUE(a.sidesOf(0).empty());
}


TEST(openAddressing, meanEdgesCountAllEdgesOfTheBorder)
{
    const wallSurface wall(endedOn(halfCube(4), halfPlanes()));
    const scalarField means(meanEdges(wall, makeWallAddressing(wall)));

    for (const scalar mean : means)
    {
        EXPECT_NEAR(mean, 0.25, 1e-15);
    }
}


// ************************************************************************* //
