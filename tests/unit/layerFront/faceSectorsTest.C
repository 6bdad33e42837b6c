/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dividedSaddle.H"
#include "faceSectors.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- makeFaceSectors where some of the edges are shared, none or all
template<bool all>
static normalSectors byFaces
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const vectorField& neighbourDirections,
    const label p
)
{
    return makeFaceSectors
    (
        wall, addressing, visibility, neighbourDirections,
        bitSet(neighbourDirections.size(), all), p
    );
}


//- All that makeNormalSectors divides, and one that it does not
static List<testSurfaces::saddle> allSaddles()
{
    List<testSurfaces::saddle> all(testSurfaces::saddles());
    all.append(testSurfaces::woundFan());

    return all;
}


//- Half of a fan beside the plane x = 0, on which its first and last direction
//  are; those between go up and down
static testSurfaces::saddle halfFan(const label n, Random& random)
{
    vectorField directions(n + 1);
    forAll(directions, i)
    {
        const scalar turn = constant::mathematical::pi*i/n;
        const scalar up = random.position<scalar>(0.5, 2);
        directions[i] = normalised
        (
            vector(::sin(turn), -::cos(turn), i % 2 ? -up : up)
        );
    }
    directions[0].x() = 0;
    directions[n].x() = 0;

    wallSurface wall(testSurfaces::fan(directions));
    const label bottom = n + 2;

    // Not those behind the plane
    for (label i = 0; i < n; ++i)
    {
        wall.faces[n + i] = wall.faces[n + 1 + i];
    }
    wall.faces.setSize(2*n);
    wall.patchIDs.setSize(2*n);
    sidePatch side;
    side.normal = vector(-1, 0, 0);
    wall.border.sides.append(side);
    wall.border.edges =
        List<edge>({{0, 1}, {1, bottom}, {bottom, n + 1}, {n + 1, 0}});
    wall.border.edgeSides = labelList(4, Zero);

    return testSurfaces::saddle{"half fan of " + std::to_string(n), wall, 0};
}


//- A wound fan of quadrilaterals, whose last points are in front of or behind
//  the planes of their corners in the middle
static testSurfaces::saddle warpedFan(const scalar inFront)
{
    testSurfaces::saddle fan(testSurfaces::woundFan());
    wallSurface& wall = fan.wall;

    for (face& f : wall.faces)
    {
        const label k = f.find(fan.p);
        if (k < 0) continue;

        const edge opposite(f[(k + 1) % 3], f[(k + 2) % 3]);
        const vector normal(normalised(f.areaNormal(wall.points)));
        const label last = wall.points.size();

        wall.points.append
        (
            wall.points[fan.p]
          + 1.2*(opposite.centre(wall.points) - wall.points[fan.p])
          + inFront*normal
        );
        for (face& g : wall.faces)
        {
            const label i = g.find(opposite.start());
            const label j = g.find(opposite.end());

            if (i >= 0 && j >= 0)
            {
                g = i == g.rcIndex(j)
                  ? face({g[i], last, g[j], g[g.fcIndex(j)]})
                  : face({g[j], last, g[i], g[g.fcIndex(i)]});
            }
        }
    }

    return fan;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(faceSectors, areNeededAtTheWoundFan)
{
    const testSurfaces::saddle wound(testSurfaces::woundFan());

    EXPECT_TRUE(dividedSaddle(wound, makeNormalSectors).sectors.starts.empty());
    EXPECT_EQ(dividedSaddle(wound, byFaces<false>).sectors.starts.size(), 11);
}


TEST(faceSectors, existAmongWarpedFaces)
{
    for (const scalar inFront : {-0.02, 0.01, 0.02})
    {
        const dividedSaddle s(warpedFan(inFront), byFaces<false>);

        ASSERT_EQ(s.sectors.starts.size(), 11) << inFront;
        expectPositivePieces(s);
    }
}


TEST(faceSectors, areWithinARightAngleOfTheNormalsOfSharedEdges)
{
    label nDivided = 0;

    for (const testSurfaces::saddle& saddle : allSaddles())
    {
        const dividedSaddle s(saddle, byFaces<true>);
        const vectorField& d = s.sectors.axes;
        const vectorField& corners = s.visibility.cornerNormals[s.p];
        nDivided += d.size() > 0;

        forAll(d, i)
        {
            const vector middle(corners[i] + corners.rcValue(i));
            const vector e(s.edge(i));
            const vector across(middle - (middle & e)*e);

            EXPECT_GT(across & d[i], 0) << s.name;
            EXPECT_GT(across & d.rcValue(i), 0) << s.name;
        }
    }

    // Not always is there room for that at all edges
    EXPECT_GT(nDivided, 10);
}


TEST(faceSectors, existAtAllSaddles)
{
    for (const testSurfaces::saddle& saddle : allSaddles())
    {
        const dividedSaddle s(saddle, byFaces<false>);

        EXPECT_EQ(s.sectors.starts, identity(s.nFaces())) << s.name;
        EXPECT_EQ(s.sectors.triangles.size(), s.nFaces() - 2) << s.name;
    }
}


TEST(faceSectors, fillTheFluidOnce)
{
    Random random(17);

    for (const testSurfaces::saddle& saddle : allSaddles())
    {
        const dividedSaddle s(saddle, byFaces<false>);

        expectPositivePieces(s);
        expectNoOverlap(s, random);
    }
}


TEST(faceSectors, haveRoomAroundTheirDirections)
{
    for (const testSurfaces::saddle& saddle : allSaddles())
    {
        const dividedSaddle s(saddle, byFaces<false>);

        forAll(s.sectors.axes, k)
        {
            EXPECT_NEAR(mag(s.sectors.axes[k]), 1, 1e-14) << s.name;
            EXPECT_GT(min(s.sectors.planes[k] & s.sectors.axes[k]), 1e-3)
                << s.name;
        }
    }
}


TEST(faceSectors, areInThePlaneAtABorder)
{
    Random random(23);

    for (const label n : {3, 4, 5, 6, 9})
    {
        const dividedSaddle s(halfFan(n, random), byFaces<false>);
        const vectorField& d = s.sectors.axes;

        ASSERT_EQ(s.sectors.starts, identity(n)) << s.name;
        EXPECT_EQ(s.sectors.triangles.size(), n - 2) << s.name;
        EXPECT_NEAR(d[0].x(), 0, 1e-12) << s.name;
        EXPECT_NEAR(d[n - 1].x(), 0, 1e-12) << s.name;

        for (label i = 0; i < n; ++i)
        {
            EXPECT_GT(min(s.sectors.planes[i] & d[i]), 1e-3) << s.name;
            EXPECT_GT((s.edge(i) ^ s.edge(i + 1)) & d[i], 0) << s.name;
            EXPECT_GT(i ? (s.edge(i) ^ d[i]) & d[i - 1] : 1, 0) << s.name;
        }
        for (const face& f : s.sectors.triangles)
        {
            EXPECT_GT((d[f[0]] ^ d[f[1]]) & d[f[2]], 0) << s.name;
        }
    }
}


TEST(faceSectors, areTheAxesOfTheirPlanes)
{
    const dividedSaddle s(testSurfaces::woundFan(), byFaces<false>);

    forAll(s.sectors.axes, k)
    {
        const visibilityCone cone(makeVisibilityCone(s.sectors.planes[k]));

        EXPECT_LT(mag(cone.axis - s.sectors.axes[k]), 1e-3);
    }
}


// ************************************************************************* //
