/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "criticalPoints.H"
#include "harmonicField.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Of a function of the place, in the unit cube
template<class Function>
static criticalPoints inCube(const Function& function)
{
    const backgroundMesh mesh(testSurfaces::cubeMesh(8));
    scalarField field(mesh.points.size());

    forAll(field, p)
    {
        field[p] = function(mesh.points[p] - point(0.52, 0.47, 0.51));
    }

    return findCriticalPoints(mesh, field);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(findCriticalPoints, aSlopeHasNone)
{
    EXPECT_TRUE(inCube([](const vector& x) { return x.x(); }).none());
    EXPECT_TRUE
    (
        inCube([](const vector& x) { return x & vector(1, 2, -3); }).none()
    );
}


TEST(findCriticalPoints, aPitAndASummit)
{
    const criticalPoints pit(inCube([](const vector& x) { return magSqr(x); }));
    EXPECT_EQ(pit.minima.size(), 1);
    EXPECT_TRUE(pit.maxima.empty());

    const criticalPoints summit
    (
        inCube([](const vector& x) { return -magSqr(x); })
    );
    EXPECT_EQ(summit.maxima, pit.minima);
    EXPECT_TRUE(summit.minima.empty());
}


TEST(findCriticalPoints, aPass)
{
    for (const scalar sign : {1.0, -1.0})
    {
        const criticalPoints pass
        (
            inCube
            (
                [&](const vector& x)
                {
                    return sign*(sqr(x.x()) + sqr(x.y()) - sqr(x.z()));
                }
            )
        );

        EXPECT_GE(pass.saddles.size(), 1);
        EXPECT_TRUE(pass.minima.empty());
        EXPECT_TRUE(pass.maxima.empty());
    }
}


TEST(findCriticalPoints, noneInFieldsAroundBodies)
{
    for (const wallSurface& wall :
        {
            testSurfaces::sphere(8), testSurfaces::lBlock(6),
            testSurfaces::torus(24, 12, 1, 0.4)
        })
    {
        for (const word model : {"anisotropic", "gradientPower"})
        {
            prismLayerControls controls;
            controls.layers = testSurfaces::layersOf(5, 0.1);
            controls.field.tensor = model;
            controls.field.tolerance = 1e-12;

            const prismLayerMesh m(testSurfaces::layeredMesh(wall, controls));
            EXPECT_EQ(m.guide.fields.failure, "");
            EXPECT_TRUE
            (
                findCriticalPoints
                (
                    m.guide.fields.background, m.guide.field
                ).none()
            );
            EXPECT_GE(min(m.guide.field), 0);
            EXPECT_LE(max(m.guide.field), 1);
        }
    }
}


// ************************************************************************* //
