/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "curveEnds.H"
#include "mathematicalConstants.H"
#include "openSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The plane in front of which the fluid is
static sidePatch sideAt(const point& origin, const vector& normal)
{
    return symmetryPlane("side", origin, normal);
}


//- An open curve of n edges from x = 0 to x = 1
template<class Height>
static planeCurve graph(const label n, const Height& height)
{
    planeCurve curve;
    curve.isClosed = false;
    for (label i = 0; i <= n; ++i)
    {
        const scalar x = scalar(i)/n;
        curve.points.append(vector2D(x, height(x)));
    }

    return curve;
}


static planeCurve withEnds
(
    const planeCurve& curve,
    const List<sidePatch>& sides
)
{
    planarControls controls;
    controls.sides = sides;
    List<planeCurve> curves(1, curve);
    setCurveEnds(curves, controls);

    return curves[0];
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(curveEnds, atRightAnglesToASideThereIsNoCorner)
{
    const planeCurve level(graph(4, [](scalar) { return 0.5; }));
    const sidePatch left(sideAt(point(0, 0, 0), vector(-1, 0, 0)));
    const planeCurve made(withEnds(level, {left}));

    EXPECT_TRUE(made.goesOn[0]);
    EXPECT_FALSE(made.goesOn[1]);
}


// The curve turns by twice as much from its mirror image
TEST(curveEnds, obliqueToASideThereIsACorner)
{
    const auto goesOn = [](const scalar degrees)
    {
        const scalar slope =
            std::tan(degrees*constant::mathematical::pi/180);
        const planeCurve line(graph(4, [&](scalar x) { return slope*x; }));
        const sidePatch left(sideAt(point(0, 0, 0), vector(-1, 0, 0)));

        return withEnds(line, {left}).goesOn[0];
    };

    EXPECT_TRUE(goesOn(14));
    EXPECT_FALSE(goesOn(16));
    EXPECT_FALSE(goesOn(80));
}


TEST(curveEnds, atTwoSidesThatMeetThereIsACorner)
{
    const planeCurve level(graph(4, [](scalar) { return 0; }));
    const sidePatch left(sideAt(point(0, 0, 0), vector(-1, 0, 0)));
    const sidePatch low(sideAt(point(0, 0, 0), vector(0, -1, 0)));

    EXPECT_FALSE(withEnds(level, {left, low}).goesOn[0]);
}


TEST(curveEnds, beyondCyclicSidesTheImageGoesOn)
{
    const planeCurve wave
    (
        graph
        (
            40, [](const scalar x)
            {
                return 0.3*std::sin(constant::mathematical::twoPi*x);
            }
        )
    );
    const List<sidePatch> cyclic(SubList<sidePatch>(cyclicPlanes(), 2));
    List<sidePatch> mirrors(cyclic);
    for (sidePatch& side : mirrors)
    {
        side.type = "patch";
    }

    for (label end = 0; end < 2; ++end)
    {
        EXPECT_TRUE(withEnds(wave, cyclic).goesOn[end]);
        EXPECT_FALSE(withEnds(wave, mirrors).goesOn[end]);
    }

    const planeCurve saw(graph(4, [](scalar x) { return min(x, 1 - x); }));
    EXPECT_FALSE(withEnds(saw, cyclic).goesOn[0]);
}


TEST(curveEnds, edgesAreLongWhereTheCurveGoesOn)
{
    planeCurve level(graph(4, [](scalar) { return 0; }));
    level.goesOn[0] = true;
    const planeCurve made(resampled(level, 0.1, 0.1));
    const List<vector2D>& x = made.points;
    const label n = x.size();

    EXPECT_NEAR(mag(x[1] - x[0]), 0.1, 0.01);
    EXPECT_NEAR(mag(x[n - 1] - x[n - 2]), 0.01, 2e-3);
}

// ************************************************************************* //
