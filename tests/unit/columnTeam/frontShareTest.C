/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frontShare.H"
#include "openSurfaces.H"
#include "testLayers.H"
#include "threadTeam.H"
#include "wallSmoother.H"
#include "HashSet.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- A closed wall, one with multiple normals, and one that ends
static List<layerFront> wholeFronts()
{
    return List<layerFront>
    ({
        testSurfaces::frontOf(testSurfaces::sphere(6), 0),
        testSurfaces::frontOf(testSurfaces::quadCube(4), 45.1),
        testSurfaces::frontOf
        (
            testSurfaces::endedOn
            (
                testSurfaces::duct(6), wordList({"inlet", "outlet"})
            ),
            0
        )
    });
}


static List<frontShare> sharesOf(const layerFront& front, const label n)
{
    const label nPoints = max(front.wallPoints) + 1;
    List<frontShare> shares(n);
    forAll(shares, p)
    {
        shares[p] = shareOf(front, ownersByRange(nPoints, n), n, p);
    }

    return shares;
}


//- Labels of a list in the whole front
static labelList inWhole(const labelUList& list, const labelUList& labels)
{
    labelList whole(list);
    for (label& i : whole)
    {
        i = labels[i];
    }

    return whole;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(frontShare, eachColumnHasOneOwner)
{
    for (const layerFront& front : wholeFronts())
    {
        labelList nOwners(front.wallPoints.size(), 0);
        for (const frontShare& share : sharesOf(front, 5))
        {
            forAll(share.columns, c)
            {
                nOwners[share.columns[c]] += share.isOwn[c];
            }
        }
        EXPECT_EQ(nOwners, labelList(nOwners.size(), 1));
    }
}


TEST(frontShare, whatIsAroundOwnColumnsIsWhole)
{
    for (const layerFront& front : wholeFronts())
    {
        for (const frontShare& share : sharesOf(front, 4))
        {
            const layerFront& part = share.front;

            forAll(share.columns, c)
            {
                const label whole = share.columns[c];
                EXPECT_EQ(part.surface.points[c], front.surface.points[whole]);
                EXPECT_EQ
                (
                    share.columns[part.wallPoints[c]], front.wallPoints[whole]
                );
                if (share.isOwn[c])
                {
                    EXPECT_EQ
                    (
                        inWhole(part.addressing.pointFaces[c], share.faces),
                        front.addressing.pointFaces[whole]
                    );
                    EXPECT_EQ
                    (
                        inWhole(part.addressing.pointPoints[c], share.columns),
                        front.addressing.pointPoints[whole]
                    );
                }
            }
            forAll(share.faces, facei)
            {
                EXPECT_EQ
                (
                    inWhole(part.surface.faces[facei], share.columns),
                    front.surface.faces[share.faces[facei]]
                );
            }
        }
    }
}


TEST(frontShare, ownersKnowTheCopiesOfTheirColumns)
{
    for (const layerFront& front : wholeFronts())
    {
        const List<frontShare> shares(sharesOf(front, 4));

        forAll(shares, p)
        {
            forAll(shares, q)
            {
                EXPECT_EQ
                (
                    inWhole(shares[p].sent[q], shares[p].columns),
                    inWhole(shares[q].received[p], shares[q].columns)
                );
            }
        }
    }
}


TEST(frontShare, columnsWithoutNeighboursHaveNoMean)
{
    const layerFront front
    (
        testSurfaces::frontOf(testSurfaces::bladeOnEdge(0.5), 0)
    );
    label nWithout = 0;

    for (const frontShare& share : sharesOf(front, 6))
    {
        const wallSmoother smoother
        (
            share.front.surface, share.front.addressing
        );
        const scalarField ones(share.columns.size(), 1);

        forAll(ones, c)
        {
            const scalar mean = smoother.mean(ones, c);
            nWithout += mean == 0;
            EXPECT_TRUE(mean == 0 || mag(mean - 1) < 1e-14);
            EXPECT_TRUE(mean > 0 || !share.isOwn[c]);
        }
    }
    EXPECT_GT(nWithout, 0);
}


TEST(frontShare, hasNoMoreThanTwoRingsAroundItsColumns)
{
    const layerFront front(testSurfaces::frontOf(testSurfaces::sphere(24), 0));

    for (const frontShare& share : sharesOf(front, 4))
    {
        labelHashSet near;
        forAll(share.columns, c)
        {
            if (share.isOwn[c])
            {
                near.insert(share.columns[c]);
            }
        }
        for (label ring = 0; ring < 2; ++ring)
        {
            for (const label c : near.toc())
            {
                near.insert(front.addressing.pointPoints[c]);
            }
        }
        EXPECT_EQ(labelHashSet(share.columns), near);
        EXPECT_LT(share.columns.size(), front.wallPoints.size()/2);
    }
}


// ************************************************************************* //
