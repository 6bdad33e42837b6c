/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movableColumns.H"
#include "prismQuality.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(movingColumns, standOnTheFrontAtFirst)
{
    for (const layerFront& front : fronts())
    {
        const movableColumns m(front);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            EXPECT_EQ(m.moving.layers()(c, 0), front.surface.points[c]);
        }
        EXPECT_EQ
        (
            m.moving.layers().extraColumnPoints, front.extraColumnPoints()
        );
        EXPECT_EQ(m.moving.layers().faces, front.surface.faces);
        EXPECT_EQ(m.moving.layers().nWallFaces(), front.nWallFaces);
    }
}


TEST(movingColumns, retreatTakesAFifthOfTheRoom)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const scalarField before(m.moving.room());
        m.moving.retreat(labelList(1, 5), squeezeCause::validity);

        EXPECT_NEAR(m.moving.room()[5], 0.8*before[5], 1e-15);
    }
}


TEST(movingColumns, retreatNeverRaises)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const scalarField before(m.moving.room());
        m.moving.retreat(someColumns(m, 5), squeezeCause::validity);

        EXPECT_LE(max(m.moving.room() - before), 0);
    }
}


TEST(movingColumns, retreatBoundsTheGradient)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);

        for (label i = 0; i < 20; ++i)
        {
            m.moving.retreat(labelList(1, 5), squeezeCause::validity);
        }

        const scalarField& room = m.moving.room();
        for (const edge& e : front.addressing.edges)
        {
            EXPECT_LE
            (
                mag(room[e.start()] - room[e.end()]),
                layerColumns::maxSlope*e.mag(front.surface.points) + 1e-15
            );
        }
    }
}


TEST(movingColumns, columnsOnAPointRetreatTogether)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const label last = m.nColumns() - 1;
        m.moving.retreat(labelList(1, last), squeezeCause::validity);

        for (label c = 0; c < m.nColumns(); ++c)
        {
            if (front.wallPoints[c] == front.wallPoints[last])
            {
                EXPECT_EQ(m.moving.room()[c], m.moving.room()[last]);
            }
        }
    }
}


TEST(movingColumns, retreatTellsWhy)
{
    label nNeighbours = 0;

    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const scalarField before(m.moving.room());
        const List<squeezeCause> causes(m.columns.causes);

        for (label i = 0; i < 20; ++i)
        {
            m.moving.retreat(labelList(1, 5), squeezeCause::intersection);
        }

        for (label c = 0; c < m.nColumns(); ++c)
        {
            const bool lower = m.moving.room()[c] < before[c];
            nNeighbours += lower && c != 5;

            EXPECT_EQ
            (
                m.columns.causes[c],
                c == 5 ? squeezeCause::intersection
              : lower && causes[c] == squeezeCause::none
              ? squeezeCause::neighbour
              : causes[c]
            );
        }
    }

    EXPECT_GT(nNeighbours, 0);
}


TEST(movingColumns, heightIsAllTheRoomOnFlatFaces)
{
    // Where edges and corners have a column for each side
    movableColumns m(fronts()[3]);
    m.moving.retreat(someColumns(m, 20), squeezeCause::validity);

    for (label c = 0; c < m.nColumns(); ++c)
    {
        const vectorField& normals = m.front.visibility.cornerNormals[c];

        EXPECT_NEAR
        (
            (m.end(c) - m.front.surface.points[c]) & normals[0],
            m.moving.room()[c],
            1e-14
        );
    }
}


TEST(movingColumns, trialOfARetreatLeavesNoTrace)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const pointField before(m.moving.layers().points);
        const scalarField room(m.moving.room());
        m.moving.takeMoved();

        for (const label c : front.surface.faces[7])
        {
            m.moving.jacobianOfRetreat(7, c);
        }

        EXPECT_EQ(m.moving.layers().points, before);
        EXPECT_EQ(m.moving.room(), room);
        EXPECT_FALSE(m.moving.takeMoved().found(true));
    }
}


TEST(movingColumns, trialOfARetreatIsWhatARetreatGives)
{
    movableColumns m(fronts()[0]);
    const label c = m.front.surface.faces[7][0];

    const scalar trial = m.moving.jacobianOfRetreat(7, c);
    m.moving.retreat(labelList(1, c), squeezeCause::validity);

    EXPECT_NEAR(worstJacobian(m.moving.layers(), 7), trial, 1e-14);
}


TEST(movingColumns, allFacesAreCandidatesAtFirst)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const label nFaces = front.surface.faces.size();

        EXPECT_EQ(m.moving.takeCandidates(), identity(nFaces));
        EXPECT_EQ(findIndices(m.moving.takeMoved(), true), identity(nFaces));
    }
}


TEST(movingColumns, facesAreTakenOnce)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        m.moving.retreat(someColumns(m, 3), squeezeCause::validity);
        m.moving.takeCandidates();
        m.moving.takeMoved();

        EXPECT_TRUE(m.moving.takeCandidates().empty());
        EXPECT_FALSE(m.moving.takeMoved().found(true));
    }
}


TEST(movingColumns, movedFacesAreThoseAroundMovedColumns)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        m.moving.takeCandidates();
        m.moving.takeMoved();
        const pointField before(m.moving.layers().points);

        m.moving.retreat(someColumns(m, 3), squeezeCause::validity);
        const labelList faces(facesOf(m, movedColumns(m, before)));

        EXPECT_EQ(m.moving.takeCandidates(), faces);
        EXPECT_EQ(findIndices(m.moving.takeMoved(), true), faces);
    }
}


TEST(movingColumns, turnThreeTimesAtMost)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        label n = 0;

        while (n < 100 && m.moving.turn(labelList(1, 3)))
        {
            ++n;
        }

        EXPECT_EQ(n, 3);
    }
}


TEST(movingColumns, movedFacesAreThoseAroundColumnsThatTurn)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        m.moving.takeCandidates();
        m.moving.takeMoved();

        m.moving.turn(labelList(1, 3));
        labelList columns(front.addressing.pointPoints[3]);
        columns.append(3);

        const labelList faces(facesOf(m, columns));
        EXPECT_EQ(m.moving.takeCandidates(), faces);
        EXPECT_EQ(findIndices(m.moving.takeMoved(), true), faces);
    }
}


// ************************************************************************* //
