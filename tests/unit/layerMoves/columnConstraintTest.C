/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bendColumns.H"
#include "editedColumns.H"
#include "fitHeights.H"
#include "leanColumns.H"
#include "limitHeightJumps.H"
#include "retreatColumns.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A rough ball of radius 1, whose points near z = 0 are in that plane
static layerFront roughBall()
{
    wallSurface wall(testSurfaces::sphere(8));

    Random random(11);
    for (point& p : wall.points)
    {
        p *= 1 + 0.03*random.sample01<scalar>();

        if (mag(p.z()) < 0.05)
        {
            p.z() = 0;
        }
    }

    return testSurfaces::frontOf(wall, 0);
}


static bool isConstrained(const layerFront& front, const label c)
{
    return mag(front.surface.points[c].z()) < SMALL;
}


//- Constraints of the columns in the plane
static List<columnConstraint> constraints
(
    const layerFront& front,
    const columnConstraint& constraint
)
{
    List<columnConstraint> all(front.wallPoints.size());
    forAll(all, c)
    {
        if (isConstrained(front, c))
        {
            all[c] = constraint;
        }
    }

    return all;
}


//- The moves, one after the other; after each a test looks at the columns
template<class Test>
static void forAllMoves(editedColumns& m, const Test& test)
{
    const labelList all(identity(m.nColumns()));

    EXPECT_TRUE(turnColumns(m.editor, all, m.nTurns));
    test("turn");
    const labelList leaned
    (
        leanColumns(m.editor, all, distanceBeside(m), 10, m.nTries)
    );
    EXPECT_FALSE(leaned.empty());
    test("lean");
    for (label i = 0; i < 6; ++i)
    {
        retreatColumns(m.editor, someColumns(m, 5), squeezeCause::validity);
    }
    test("retreat");
    growColumns(m.editor, all, [](label) { return false; });
    test("grow");
    fitFirstHeights(m.editor, boolList(m.nColumns(), true), 1);
    test("fitFirstHeights");
    fitThickness(m.editor);
    test("fitThickness");
    limitHeightJumps(m.editor, neighboursOnWall(m.front));
    test("limitHeightJumps");
    editedGeometry geometry(m.editor);
    bendTargets targets;
    targets.faces = faceTargets{0.95, 0.5};
    targets.keep(m.editor, all);
    EXPECT_FALSE
    (
        bendColumns
        (
            m.editor, geometry, targets, all, [](label) { return false; }
        ).empty()
    );
    test("bend");
}


//- Largest distance of the points of constrained columns from where they may be
template<class Distance>
static scalar largestDistance(const editedColumns& m, const Distance& distance)
{
    scalar largest = 0;
    for (label c = 0; c < m.nColumns(); ++c)
    {
        for (label i = 1; isConstrained(m.front, c) && i <= 4; ++i)
        {
            largest = max(largest, distance(m.editor.layers()(c, i)));
        }
    }

    return largest;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(columnConstraint, freePointsAndDirectionsStay)
{
    const columnConstraint free;
    const point x(1, 2, 3);

    EXPECT_EQ(free.allowedPoint(x), x);
    EXPECT_EQ(free.allowed(x), x);
    EXPECT_FALSE(free.isFixed());
}


TEST(columnConstraint, planesTakeTheNormalAway)
{
    const vector n(normalised(vector(1, 2, 2)));
    const point origin(0.3, 0.2, 0.1);
    const columnConstraint plane(columnConstraint::inPlane(origin, n));
    const point x(1, -2, 3);

    EXPECT_NEAR((plane.allowedPoint(x) - origin) & n, 0, 1e-15);
    EXPECT_NEAR(mag((x - plane.allowedPoint(x)) ^ n), 0, 1e-15);
    EXPECT_NEAR(plane.allowed(x) & n, 0, 1e-15);
    EXPECT_NEAR(mag((x - plane.allowed(x)) ^ n), 0, 1e-15);
}


TEST(columnConstraint, surfacesAndCurvesTakeDirectionsOutOfTheTangents)
{
    const vector n(normalised(vector(1, 2, 2)));
    const auto origin = [](const point&) { return point(0, 0, 1); };
    const columnConstraint surface(columnConstraint::onSurface(n, origin));
    const columnConstraint curve(columnConstraint::onCurve(n, origin));
    const point x(1, -2, 3);

    EXPECT_NEAR(surface.allowed(x) & n, 0, 1e-15);
    EXPECT_NEAR(mag(curve.allowed(x) ^ n), 0, 1e-15);
    EXPECT_EQ(surface.allowedPoint(x), point(0, 0, 1));
    EXPECT_EQ(curve.allowedPoint(x), point(0, 0, 1));
}


TEST(columnConstraint, columnsInAPlaneStayThereInAllMoves)
{
    const layerFront front(roughBall());
    editedColumns m
    (
        front,
        constraints
        (
            front, columnConstraint::inPlane(point(0, 0, 0), vector(0, 0, 1))
        )
    );

    const auto distance = [](const point& x) { return mag(x.z()); };
    EXPECT_LT(largestDistance(m, distance), 1e-15);

    const label now = m.editor.now();
    forAllMoves(m, [&](const char* move)
    {
        EXPECT_LT(largestDistance(m, distance), 1e-15) << move;
    });

    // They do move
    label nTouched = 0;
    for (const label facei : m.editor.touchedSince(now))
    {
        for (const label c : front.surface.faces[facei])
        {
            nTouched += isConstrained(front, c);
        }
    }
    EXPECT_GT(nTouched, 20);
}


TEST(columnConstraint, columnsInAPlaneKeepTheirHeight)
{
    const layerFront front(roughBall());
    editedColumns m
    (
        front,
        constraints
        (
            front, columnConstraint::inPlane(point(0, 0, 0), vector(0, 0, 1))
        )
    );

    for (label c = 0; c < m.nColumns(); ++c)
    {
        if (isConstrained(front, c))
        {
            const point& root = front.surface.points[c];
            const scalar before =
                front.visibility.heightCosine(c, m.end(c) - root);
            m.editor.setDirections
            (
                c, m.editor.state(c),
                vectorField
                (
                    4, front.visibility.cones[c].axis + vector(0, 0, 1)
                )
            );

            EXPECT_NEAR
            (
                front.visibility.heightCosine(c, m.end(c) - root)/before,
                1, 1e-12
            );
        }
    }
}


TEST(columnConstraint, columnsOnASurfaceStayThereInAllMoves)
{
    // A cylinder about the y axis, through the equator at x = z = 0
    const layerFront front(roughBall());
    const point centre(0, 0, -3);
    const auto onCylinder = [=](const point& x)
    {
        const vector radial(x.x() - centre.x(), 0, x.z() - centre.z());
        const vector d((3/mag(radial))*radial);

        return point(centre.x() + d.x(), x.y(), centre.z() + d.z());
    };
    editedColumns m
    (
        front,
        constraints
        (
            front, columnConstraint::onSurface(vector(0, 0, 1), onCylinder)
        )
    );

    const auto distance = [&](const point& x)
    {
        return mag(x - onCylinder(x));
    };
    EXPECT_LT(largestDistance(m, distance), 1e-14);

    forAllMoves(m, [&](const char* move)
    {
        EXPECT_LT(largestDistance(m, distance), 1e-14) << move;
    });
}


TEST(columnConstraint, fixedColumnsNeverMove)
{
    const layerFront front(roughBall());
    editedColumns m(front, constraints(front, columnConstraint::fixed()));
    const pointField before(m.editor.layers().points);
    const scalarField thickness(m.editor.thickness());
    const List<squeezeCause> causes(m.editor.causes());

    forAllMoves(m, [&](const char* move)
    {
        for (const label c : movedColumns(m, before))
        {
            EXPECT_FALSE(isConstrained(front, c)) << move;
        }
        for (label c = 0; c < m.nColumns(); ++c)
        {
            if (isConstrained(front, c))
            {
                EXPECT_EQ(m.editor.thickness()[c], thickness[c]) << move;
                EXPECT_EQ(m.editor.causes()[c], causes[c]) << move;
            }
        }
    });

    EXPECT_GT(movedColumns(m, before).size(), m.nColumns()/2);
}


// ************************************************************************* //
