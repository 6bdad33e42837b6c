/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedColumns.H"
#include "fitHeights.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Mean heights of a level above the wall's faces, over those asked for
static scalarField heightsAt(const editedColumns& m, const label level)
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
              & (m.editor.layers()(c, level) - surface.points[c])
            )/(f.size()*asked[c*m.spacing.nLayers + level - 1]);
        }
    }

    return heights;
}


static scalarField firstHeights(const editedColumns& m)
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
static labelList columnsChanged(const editedColumns& m)
{
    DynamicList<label> changed;
    for (label c = 0; c < m.nColumns(); ++c)
    {
        if (m.editor.isChanged(c))
        {
            changed.append(c);
        }
    }

    return labelList(std::move(changed));
}


static labelList fitted
(
    editedColumns& m,
    const scalar reach = 1,
    const bool wanted = true
)
{
    m.editor.record();
    fitFirstHeights(m.editor, boolList(m.nColumns(), wanted), reach);

    return columnsChanged(m);
}


static scalar largestError(const scalarField& heights)
{
    return max(mag(heights - 1));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(fitHeights, facesGetTheHeightAskedFor)
{
    editedColumns m(unevenBall());

    EXPECT_GT(largestError(firstHeights(m)), 0.02);
    EXPECT_GT(fitted(m).size(), 0);
    EXPECT_LT(largestError(firstHeights(m)), 0.01);
}


TEST(fitHeights, facesThatAreTooThickLoseTheirExcess)
{
    editedColumns m(unevenBall(16, 0.05));
    const label n = m.spacing.nLayers;
    const scalarField before(heightsAt(m, n));

    m.editor.record();
    fitThickness(m.editor);

    const scalarField after(heightsAt(m, n));
    EXPECT_GT(columnsChanged(m).size(), 0);
    EXPECT_GT(max(before), 1.08);
    EXPECT_LT(max(after) - 1, 0.5*(max(before) - 1));
    EXPECT_GT(min(after), min(before) - 0.02);

    // Less of it where layers are low
    EXPECT_LT
    (
        sum(mag(heightsAt(m, 1) - firstHeights(editedColumns(m.front)))),
        0.5*sum(mag(after - before))
    );
}


TEST(fitHeights, facesThatAreNotTooThickKeepTheirColumns)
{
    editedColumns m(testSurfaces::frontOf(testSurfaces::cube(8), 0));
    const pointField before(m.editor.layers().points);

    fitThickness(m.editor);

    EXPECT_EQ(m.editor.layers().points, before);
}


TEST(fitHeights, thoseOfRightHeightOrFullLengthStay)
{
    // Full length: those on the corners of the cube
    editedColumns m(testSurfaces::frontOf(testSurfaces::cube(8), 0));
    const pointField before(m.editor.layers().points);

    EXPECT_TRUE(fitted(m).empty());
    EXPECT_EQ(m.editor.layers().points, before);
}


TEST(fitHeights, reachIsWhereDisplacementsFade)
{
    const auto displacements = [](const scalar reach)
    {
        editedColumns m(unevenBall());
        const pointField before(m.editor.layers().points);
        fitted(m, reach);

        return scalarField(mag(m.editor.layers().points - before));
    };
    const scalarField far(displacements(1)), near(displacements(0.05));

    EXPECT_LT(sum(near), 0.5*sum(far));
    EXPECT_GT(sum(near), 0);
}


TEST(fitHeights, thoseNotWantedMoveForLargeErrorsOnly)
{
    const auto moved = [](const bool wanted)
    {
        editedColumns m(unevenBall(10, 0.02));

        return fitted(m, 1, wanted).size();
    };

    EXPECT_LT(moved(false), 0.8*moved(true));
}


TEST(fitHeights, facesAroundThoseDisplacedAreMoved)
{
    editedColumns m(unevenBall());
    const label now = m.editor.now();
    const pointField before(m.editor.layers().points);
    const labelList displaced(fitted(m));
    const labelList faces(facesOf(m, displaced));

    EXPECT_EQ(m.editor.touchedSince(now), faces);

    for (const label c : movedColumns(m, before))
    {
        EXPECT_TRUE(displaced.found(c));
    }
}


TEST(fitHeights, noneGoesFar)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const pointField before(m.editor.layers().points);
        fitted(m);

        forAll(before, k)
        {
            const label n = m.spacing.nLayers + 1;
            const scalar height = mag(before[k] - before[k - k % n]);

            EXPECT_LE
            (
                mag(m.editor.layers().points[k] - before[k]),
                0.4*height*(1 + SMALL)
            );
        }
    }
}


TEST(fitHeights, thoseRolledBackAreWhereTheyWere)
{
    editedColumns m(unevenBall());
    const pointField before(m.editor.layers().points);
    ASSERT_TRUE(fitted(m).found(5));
    m.editor.rollBack(5);

    EXPECT_FALSE(movedColumns(m, before).found(5));
}


// ************************************************************************* //
