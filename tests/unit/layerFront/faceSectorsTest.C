/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dividedSaddle.H"
#include "faceSectors.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- All that makeNormalSectors divides, and one that it does not
static List<testSurfaces::saddle> allSaddles()
{
    List<testSurfaces::saddle> all(testSurfaces::saddles());
    all.append(testSurfaces::woundFan());

    return all;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(faceSectors, areNeededAtTheWoundFan)
{
    const testSurfaces::saddle wound(testSurfaces::woundFan());

    EXPECT_TRUE(dividedSaddle(wound, makeNormalSectors).sectors.starts.empty());
    EXPECT_EQ(dividedSaddle(wound, makeFaceSectors).sectors.starts.size(), 11);
}


TEST(faceSectors, existAtAllSaddles)
{
    for (const testSurfaces::saddle& saddle : allSaddles())
    {
        const dividedSaddle s(saddle, makeFaceSectors);

        EXPECT_EQ(s.sectors.starts, identity(s.nFaces())) << s.name;
        EXPECT_EQ(s.sectors.triangles.size(), s.nFaces() - 2) << s.name;
    }
}


TEST(faceSectors, fillTheFluidOnce)
{
    Random random(17);

    for (const testSurfaces::saddle& saddle : allSaddles())
    {
        const dividedSaddle s(saddle, makeFaceSectors);

        expectPositivePieces(s);
        expectNoOverlap(s, random);
    }
}


TEST(faceSectors, haveRoomAroundTheirDirections)
{
    for (const testSurfaces::saddle& saddle : allSaddles())
    {
        const dividedSaddle s(saddle, makeFaceSectors);

        forAll(s.sectors.axes, k)
        {
            EXPECT_NEAR(mag(s.sectors.axes[k]), 1, 1e-14) << s.name;
            EXPECT_GT(min(s.sectors.planes[k] & s.sectors.axes[k]), 1e-3)
                << s.name;
        }
    }
}


TEST(faceSectors, areTheAxesOfTheirPlanes)
{
    const dividedSaddle s(testSurfaces::woundFan(), makeFaceSectors);

    forAll(s.sectors.axes, k)
    {
        const visibilityCone cone(makeVisibilityCone(s.sectors.planes[k]));

        EXPECT_LT(mag(cone.axis - s.sectors.axes[k]), 1e-3);
    }
}


// ************************************************************************* //
