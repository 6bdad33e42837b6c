/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movableColumns.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Mean heights of a level above the wall's faces, over those asked for
static scalarField heightsAt(const movableColumns& m, const label level)
{
    const scalarField asked(requestedHeights(m.spacing));
    const wallSurface& surface = m.front.surface;
    const vectorField normals(surface.faceNormals());
    scalarField heights(m.front.nWallFaces, 0);

    forAll(heights, facei)
    {
        const face& f = surface.faces[facei];

        for (const label c : f)
        {
            heights[facei] +=
            (
                normals[facei]
              & (m.moving.layers()(c, level) - surface.points[c])
            )/(f.size()*asked[c*m.spacing.nLayers + level - 1]);
        }
    }

    return heights;
}


static scalarField firstHeights(const movableColumns& m)
{
    return heightsAt(m, 1);
}


//- A coarse ball, on which columns as high as the mean asks for make faces too
//  low and too high
static layerFront unevenBall(const label n = 4, const scalar roughness = 0.15)
{
    wallSurface wall(testSurfaces::sphere(n));

    Random random(11);
    for (point& p : wall.points)
    {
        p *= 1 + roughness*random.sample01<scalar>();
    }

    return testSurfaces::frontOf(wall, 0);
}


//- The columns that fit moves
static labelList fitted(movableColumns& m, const scalar reach = 1)
{
    DynamicList<label> moved;
    m.moving.fitFirst
    (
        boolList(m.nColumns(), true), reach,
        [&](const label c) { moved.append(c); }
    );

    return labelList(std::move(moved));
}


static scalar largestError(const scalarField& heights)
{
    return max(mag(heights - 1));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(fittingColumns, facesGetTheHeightAskedFor)
{
    movableColumns m(unevenBall());

    EXPECT_GT(largestError(firstHeights(m)), 0.02);
    EXPECT_GT(fitted(m).size(), 0);
    EXPECT_LT(largestError(firstHeights(m)), 0.01);
}


TEST(fittingColumns, facesThatAreTooThickLoseTheirExcess)
{
    movableColumns m(unevenBall(16, 0.05));
    const label n = m.spacing.nLayers;
    const scalarField before(heightsAt(m, n));
    DynamicList<label> moved;

    m.moving.fitThickness([&](const label c) { moved.append(c); });

    const scalarField after(heightsAt(m, n));
    EXPECT_GT(moved.size(), 0);
    EXPECT_GT(max(before), 1.08);
    EXPECT_LT(max(after) - 1, 0.5*(max(before) - 1));
    EXPECT_GT(min(after), min(before) - 0.02);

    // Less of it where layers are low
    EXPECT_LT
    (
        sum(mag(heightsAt(m, 1) - firstHeights(movableColumns(m.front)))),
        0.5*sum(mag(after - before))
    );
}


TEST(fittingColumns, facesThatAreNotTooThickKeepTheirColumns)
{
    movableColumns m(testSurfaces::frontOf(testSurfaces::cube(8), 0));
    const pointField before(m.moving.layers().points);

    m.moving.fitThickness([](const label) {});

    EXPECT_EQ(m.moving.layers().points, before);
}


TEST(fittingColumns, thoseOfRightHeightOrFullLengthStay)
{
    // Full length: those on the corners of the cube
    movableColumns m(testSurfaces::frontOf(testSurfaces::cube(8), 0));
    const pointField before(m.moving.layers().points);

    EXPECT_TRUE(fitted(m).empty());
    EXPECT_EQ(m.moving.layers().points, before);
}


TEST(fittingColumns, reachIsWhereDisplacementsFade)
{
    const auto displacements = [](const scalar reach)
    {
        movableColumns m(unevenBall());
        const pointField before(m.moving.layers().points);
        fitted(m, reach);

        return scalarField(mag(m.moving.layers().points - before));
    };
    const scalarField far(displacements(1)), near(displacements(0.05));

    EXPECT_LT(sum(near), 0.5*sum(far));
    EXPECT_GT(sum(near), 0);
}


TEST(fittingColumns, thoseNotWantedMoveForLargeErrorsOnly)
{
    const auto moved = [](const bool wanted)
    {
        movableColumns m(unevenBall(10, 0.02));
        label n = 0;
        m.moving.fitFirst
        (
            boolList(m.nColumns(), wanted), 1, [&](const label) { ++n; }
        );

        return n;
    };

    EXPECT_LT(moved(false), moved(true));
}


TEST(fittingColumns, facesAroundThoseDisplacedAreMoved)
{
    movableColumns m(unevenBall());
    m.moving.takeCandidates();
    m.moving.takeMoved();

    const pointField before(m.moving.layers().points);
    const labelList displaced(fitted(m));
    const labelList faces(facesOf(m, displaced));

    EXPECT_EQ(m.moving.takeCandidates(), faces);
    EXPECT_EQ(findIndices(m.moving.takeMoved(), true), faces);

    for (const label c : movedColumns(m, before))
    {
        EXPECT_TRUE(displaced.found(c));
    }
}


TEST(fittingColumns, noneGoesFar)
{
    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        const pointField before(m.moving.layers().points);
        fitted(m);

        forAll(before, k)
        {
            const label n = m.spacing.nLayers + 1;
            const scalar height = mag(before[k] - before[k - k % n]);

            EXPECT_LE
            (
                mag(m.moving.layers().points[k] - before[k]),
                0.4*height*(1 + SMALL)
            );
        }
    }
}


TEST(fittingColumns, restoredOnesAreWhereTheyWere)
{
    movableColumns m(unevenBall());
    const pointField before(m.moving.layers().points);
    const movingColumns::posture own(m.moving.postureOf(5));

    fitted(m);
    m.moving.restore(5, own);

    EXPECT_FALSE(movedColumns(m, before).found(5));
}


// ************************************************************************* //
