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
            forAll(share.columns.whole, c)
            {
                nOwners[share.columns.whole[c]] += share.columns.isOwn[c];
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

            forAll(share.columns.whole, c)
            {
                const label whole = share.columns.whole[c];
                EXPECT_EQ(part.surface.points[c], front.surface.points[whole]);
                EXPECT_EQ
                (
                    share.columns.whole[part.wallPoints[c]],
                    front.wallPoints[whole]
                );
                if (share.columns.isOwn[c])
                {
                    EXPECT_EQ
                    (
                        inWhole
                        (
                            part.addressing.pointFaces[c], share.faces.whole
                        ),
                        front.addressing.pointFaces[whole]
                    );
                    EXPECT_EQ
                    (
                        inWhole
                        (
                            part.addressing.pointPoints[c],
                            share.columns.whole
                        ),
                        front.addressing.pointPoints[whole]
                    );
                }
            }
            forAll(share.faces.whole, facei)
            {
                EXPECT_EQ
                (
                    inWhole(part.surface.faces[facei], share.columns.whole),
                    front.surface.faces[share.faces.whole[facei]]
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
                const sharedLabels& own = shares[p].columns;
                const sharedLabels& other = shares[q].columns;
                EXPECT_EQ
                (
                    inWhole(own.sent[q], own.whole),
                    inWhole(other.received[p], other.whole)
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
        const scalarField ones(share.columns.whole.size(), 1);

        forAll(ones, c)
        {
            const scalar mean = smoother.mean(ones, c);
            nWithout += mean == 0;
            EXPECT_TRUE(mean == 0 || mag(mean - 1) < 1e-14);
            EXPECT_TRUE(mean > 0 || !share.columns.isOwn[c]);
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
        forAll(share.columns.whole, c)
        {
            if (share.columns.isOwn[c])
            {
                near.insert(share.columns.whole[c]);
            }
        }
        for (label ring = 0; ring < 2; ++ring)
        {
            for (const label c : near.toc())
            {
                near.insert(front.addressing.pointPoints[c]);
            }
        }
        EXPECT_EQ(labelHashSet(share.columns.whole), near);
        EXPECT_LT(share.columns.whole.size(), front.wallPoints.size()/2);
    }
}


// ************************************************************************* //
