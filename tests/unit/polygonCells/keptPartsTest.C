/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "keptParts.H"

#include "prismFaces.H"
#include "Random.H"
#include "testLayers.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The front on a cube of triangles
struct cubeFront
{
    const prismLayers layers;
    const labelListList neighbours;
    const frontGroups groups;

    cubeFront()
    :
        layers(straightLayers(cube(5), geometricHeights(2, 0.1, 1.2))),
        neighbours(findFaceNeighbours(layers)),
        groups(groupFront(layers, neighbours, polygonControls(), {}))
    {}

    //- Number of the neighbours of a face that are divided
    label nDivided(const label facei, const bitSet& whole) const
    {
        label n = 0;
        for (const label other : neighbours[facei])
        {
            n += other >= 0 && !whole.test(other);
        }

        return n;
    }

    bitSet keptBeside(const bitSet& whole) const
    {
        groupExceptions exceptions;
        exceptions.whole = whole;
        keepNeighbours(layers, neighbours, groups, exceptions);

        return exceptions.whole;
    }
};

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(keptParts, noTriangleThatStaysHasOneDividedNeighbour)
{
    const cubeFront front;
    const label nFaces = front.layers.faces.size();
    Random random(1);
    for (label trial = 0; trial < 20; ++trial)
    {
        bitSet whole(nFaces);
        for (label i = 0; i < nFaces/4; ++i)
        {
            whole.set(random.position<label>(0, nFaces - 1));
        }
        const bitSet kept(front.keptBeside(whole));
        for (const label facei : whole)
        {
            EXPECT_TRUE(kept.test(facei));
        }
        for (const label facei : kept)
        {
            EXPECT_NE(front.nDivided(facei, kept), 1);
        }
    }
}


TEST(keptParts, aTriangleOrTwoStayAlone)
{
    const cubeFront front;
    bitSet whole;
    whole.set(0);
    EXPECT_EQ(front.keptBeside(whole).count(), 1);
    whole.set(front.neighbours[0][0]);
    EXPECT_EQ(front.keptBeside(whole).count(), 2);

    // One between two others has one divided neighbour left, which stays
    const label middle = front.neighbours[0][0];
    const labelList& around = front.neighbours[middle];
    whole.set(around);
    whole.unset(around[0] == 0 ? around[1] : around[0]);
    EXPECT_EQ(front.keptBeside(whole).count(), 4);
}


TEST(keptParts, keepAtTakesEdgesBetweenPoints)
{
    const List<FixedList<label, 4>> tets
    ({
        FixedList<label, 4>({0, 1, 2, 3}), FixedList<label, 4>({3, 4, 5, 6}),
        FixedList<label, 4>({7, 8, 9, 10})
    });
    bitSet points;
    points.set(labelList({0, 3, 4}));
    bitSet whole;
    EXPECT_EQ(keepAt(points, tets, whole), 2);
    EXPECT_EQ(whole.toc(), labelList({0, 1}));
    EXPECT_EQ(keepAt(points, tets, whole), 0);
}


// ************************************************************************* //
