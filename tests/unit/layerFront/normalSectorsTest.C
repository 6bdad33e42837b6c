/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dividedSaddle.H"

#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Made once: all tests look at the same
static const std::vector<dividedSaddle>& saddles()
{
    static std::vector<dividedSaddle> list;

    if (list.empty())
    {
        for (const testSurfaces::saddle& s : testSurfaces::saddles())
        {
            list.emplace_back(s, makeNormalSectors);
        }
    }

    return list;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(normalSectors, allOfThesePointsSeeNothing)
{
    for (const dividedSaddle& s : saddles())
    {
        ASSERT_GE(s.p, 0) << s.name;
        EXPECT_TRUE(s.visibility.cones[s.p].empty()) << s.name;
    }
}


TEST(normalSectors, areTwoOrMore)
{
    for (const dividedSaddle& s : saddles())
    {
        EXPECT_GE(s.sectors.starts.size(), 2) << s.name;
    }
}


TEST(normalSectors, haveOneOfEverything)
{
    for (const dividedSaddle& s : saddles())
    {
        const label n = s.sectors.starts.size();

        EXPECT_EQ(s.sectors.axes.size(), n) << s.name;
        EXPECT_EQ(s.sectors.planes.size(), n) << s.name;
        EXPECT_EQ(s.sectors.triangles.size(), n - 2) << s.name;
    }
}


TEST(normalSectors, partitionTheFaces)
{
    for (const dividedSaddle& s : saddles())
    {
        const labelList& starts = s.sectors.starts;

        for (label i = 0; i < s.nFaces(); ++i)
        {
            const label before = s.sectorBefore(i);
            const label start = starts.find(i);

            // A sector begins at its start, and goes on elsewhere
            EXPECT_EQ(s.sectors.sector(i), start < 0 ? before : start)
                << s.name;
            EXPECT_EQ(s.sectors.sector(i) != before, start >= 0) << s.name;
        }
    }
}


TEST(normalSectors, startInAscendingOrder)
{
    for (const dividedSaddle& s : saddles())
    {
        for (label k = 1; k < s.sectors.starts.size(); ++k)
        {
            EXPECT_LT(s.sectors.starts[k - 1], s.sectors.starts[k]) << s.name;
        }
    }
}


TEST(normalSectors, directionsAreUnitVectors)
{
    for (const dividedSaddle& s : saddles())
    {
        EXPECT_LT(max(mag(mag(s.sectors.axes) - 1)), 1e-14) << s.name;
    }
}


TEST(normalSectors, directionsAreInFrontOfTheirFaces)
{
    for (const dividedSaddle& s : saddles())
    {
        forAll(s.sectors.axes, k)
        {
            EXPECT_GT(smallest(s, k, s.sectors.axes[k]), 0.02) << s.name;
        }
    }
}


TEST(normalSectors, directionsAreInFrontOfTheirPlanes)
{
    for (const dividedSaddle& s : saddles())
    {
        forAll(s.sectors.axes, k)
        {
            for (const vector& n : s.sectors.planes[k])
            {
                EXPECT_NEAR(mag(n), 1, 1e-14) << s.name;
                EXPECT_GT(n & s.sectors.axes[k], 0.02) << s.name;
            }
        }
    }
}


TEST(normalSectors, piecesArePositive)
{
    for (const dividedSaddle& s : saddles())
    {
        expectPositivePieces(s);
    }
}


TEST(normalSectors, piecesDoNotOverlap)
{
    Random random(11);

    for (const dividedSaddle& s : saddles())
    {
        expectNoOverlap(s, random);
    }
}


TEST(normalSectors, piecesFillTheFluidAroundScrews)
{
    Random random(13);

    for (const testSurfaces::saddle& screw : testSurfaces::screws())
    {
        const dividedSaddle s(screw, makeNormalSectors);
        const unsigned filled = std::stoi(s.name);

        for (label i = 0; i < 500; ++i)
        {
            const vector x(random.sample01<vector>() - vector::uniform(0.5));
            const label octant = 4*(x.x() > 0) + 2*(x.y() > 0) + (x.z() > 0);

            EXPECT_EQ(nPiecesAt(s, x), filled & (1u << octant) ? 0 : 1)
                << s.name;
        }
    }
}


// ************************************************************************* //
