/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatchRemainders.H"
#include "sideShape.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Two strips of 20 rectangles on both sides of the line x = z = 0, of length
//  1, the second one turned about it by an angle [rad]. Points 0 to 20 are on
//  the line, and the regions are bounded by their strips.
struct cutStrip
{
    pointField points;
    List<sidePatch> sides;
    List<planeRegion> regions;

    explicit cutStrip(const scalar angle = 0)
    :
        points(63),
        sides(2),
        regions(2)
    {
        const label n = 20;
        for (label i = 0; i <= n; ++i)
        {
            const scalar y = scalar(i)/n;
            points[i] = point(0, y, 0);
            points[i + 21] = point(-1, y, 0);
            points[i + 42] = point(::cos(angle), y, ::sin(angle));
        }

        for (const label s : {0, 1})
        {
            sides[s].name = "inlet";
            sides[s].points = points;
            for (label i = 0; i < n; ++i)
            {
                const label first = s ? i : i + 21;
                const label second = s ? i + 42 : i;
                sides[s].faces.append
                (
                    face({first, second, second + 1, first + 1})
                );
            }
            sides[s].shape = std::make_shared<const sideShape>
            (
                sides[s].points, sides[s].faces
            );
            regions[s].boundary = outline(sides[s].faces);
        }
    }


    void coarsen(const scalar size)
    {
        const std::function<scalar(const point&)> sizes
        (
            [=](const point&) { return size; }
        );
        coarsenCuts(points, sides, sizes, regions);
    }


    //- Labels of the line's edges in a region, sorted
    labelList onLine(const label s) const
    {
        DynamicList<label> ends;
        for (const edge& e : regions[s].boundary)
        {
            if (e.start() <= 20 && e.end() <= 20)
            {
                ends.append(s ? e.end() : e.start());
            }
        }
        sort(ends);

        return labelList(std::move(ends));
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(coarsenCuts, bothSectorsHaveEdgesOfTheSize)
{
    cutStrip strip;
    strip.coarsen(0.25);

    for (const label s : {0, 1})
    {
        EXPECT_EQ(strip.onLine(s), labelList({0, 5, 10, 15}));

        // 4 edges for 20, and still closed
        EXPECT_EQ(strip.regions[s].boundary.size(), 26);
        labelList balance(strip.points.size(), Zero);
        for (const edge& e : strip.regions[s].boundary)
        {
            ++balance[e.start()];
            --balance[e.end()];
        }
        EXPECT_EQ(balance, labelList(strip.points.size(), Zero));
    }
}


TEST(coarsenCuts, finePointsAreKept)
{
    cutStrip strip;
    strip.coarsen(0.01);

    EXPECT_EQ(strip.onLine(0), identity(20));
    EXPECT_EQ(strip.onLine(1), identity(20));
}


TEST(coarsenCuts, largeSizesLeaveTheEnds)
{
    cutStrip strip;
    strip.coarsen(10);

    EXPECT_EQ(strip.onLine(0), labelList({0}));
    EXPECT_EQ(strip.onLine(1), labelList({0}));
}


TEST(coarsenCuts, sharpEdgesAndThoseOfTwoPatchesAreKept)
{
    cutStrip sharp(1);
    sharp.coarsen(0.25);
    EXPECT_EQ(sharp.onLine(0), identity(20));

    cutStrip two;
    two.sides[1].name = "outlet";
    two.coarsen(0.25);
    EXPECT_EQ(two.onLine(0), identity(20));
}


// ************************************************************************* //
