/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "normalSectors.H"
#include "saddles.H"
#include "FixedList.H"
#include "Random.H"

#include <gtest/gtest.h>

#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- A saddle, divided with the mean normals of the faces of each edge
struct dividedSaddle
:
    public testSurfaces::saddle
{
    wallAddressing addressing;
    wallVisibility visibility;
    normalSectors sectors;


    explicit dividedSaddle(const testSurfaces::saddle& s)
    :
        testSurfaces::saddle(s),
        addressing(makeWallAddressing(wall)),
        visibility(makeWallVisibility(wall, addressing))
    {
        const vectorField& corners = visibility.cornerNormals[p];
        vectorField middles(corners.size());

        forAll(middles, i)
        {
            middles[i] = corners[i] + corners[corners.rcIndex(i)];
        }

        sectors = makeNormalSectors(wall, addressing, visibility, middles, p);
    }


    label nFaces() const
    {
        return addressing.pointFaces[p].size();
    }


    //- Unit vector along edge i
    vector edge(const label i) const
    {
        const label q = addressing.pointPoints[p][i % nFaces()];

        return normalised(wall.points[q] - wall.points[p]);
    }


    //- Sector of the face before face i
    label sectorBefore(const label i) const
    {
        return sectors.sector((i + nFaces() - 1) % nFaces());
    }
};


//- Made once: all tests look at the same
static const std::vector<dividedSaddle>& saddles()
{
    static std::vector<dividedSaddle> list;

    if (list.empty())
    {
        for (const testSurfaces::saddle& s : testSurfaces::saddles())
        {
            list.emplace_back(s);
        }
    }

    return list;
}


//- Smallest d.n_f of the faces of a sector
static scalar smallest
(
    const dividedSaddle& s,
    const label sector,
    const vector& d
)
{
    scalar least = GREAT;

    for (label i = 0; i < s.nFaces(); ++i)
    {
        if (s.sectors.sector(i) == sector)
        {
            least = min(least, d & s.visibility.cornerNormals[s.p][i]);
        }
    }

    return least;
}


//- The triangles that the division cuts the directions into the fluid into
static List<FixedList<vector, 3>> pieces(const dividedSaddle& s)
{
    const normalSectors& sectors = s.sectors;
    const vectorField& d = sectors.axes;
    DynamicList<FixedList<vector, 3>> all;

    for (label i = 0; i < s.nFaces(); ++i)
    {
        const label k = sectors.sector(i);
        const label before = s.sectorBefore(i);

        all.append(FixedList<vector, 3>({s.edge(i), s.edge(i + 1), d[k]}));
        if (before != k)
        {
            all.append(FixedList<vector, 3>({s.edge(i), d[k], d[before]}));
        }
    }

    for (const face& f : sectors.triangles)
    {
        all.append(FixedList<vector, 3>({d[f[0]], d[f[1]], d[f[2]]}));
    }

    return List<FixedList<vector, 3>>(std::move(all));
}


static label nPiecesAt(const dividedSaddle& s, const vector& x)
{
    label n = 0;

    for (const FixedList<vector, 3>& t : pieces(s))
    {
        n += ((t[0] ^ t[1]) & x) > 0
          && ((t[1] ^ t[2]) & x) > 0
          && ((t[2] ^ t[0]) & x) > 0;
    }

    return n;
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
        for (const FixedList<vector, 3>& t : pieces(s))
        {
            EXPECT_GT((t[0] ^ t[1]) & t[2], 0) << s.name;
        }
    }
}


TEST(normalSectors, piecesDoNotOverlap)
{
    Random random(11);

    for (const dividedSaddle& s : saddles())
    {
        for (label i = 0; i < 500; ++i)
        {
            const vector x(random.sample01<vector>() - vector::uniform(0.5));

            EXPECT_LE(nPiecesAt(s, x), 1) << s.name;
        }
    }
}


TEST(normalSectors, piecesFillTheFluidAroundScrews)
{
    Random random(13);

    for (const testSurfaces::saddle& screw : testSurfaces::screws())
    {
        const dividedSaddle s(screw);
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
