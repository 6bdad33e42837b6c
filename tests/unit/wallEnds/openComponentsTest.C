/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "orientOpenWall.H"
#include "boundBox.H"
#include "openSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(openComponents, capsCloseABodyOnPlanes)
{
    for (const label nPlanes : {1, 2})
    {
        const wallSurface body(nPlanes == 1 ? halfCube(4) : quarterCube(4));
        const List<sidePatch> planes
        (
            nPlanes == 1 ? halfPlanes() : quarterPlanes()
        );
        const List<openComponent> components(openComponents(body, planes));

        ASSERT_EQ(components.size(), 1);
        EXPECT_EQ(components[0].faces.size(), body.faces.size());
        EXPECT_EQ(components[0].turnsCorner(), nPlanes == 2);

        const List<triPoints> triangles
        (
            cappedTriangles(body, planes, components[0])
        );
        EXPECT_NEAR(volumeOf(triangles), 0.5/nPlanes, 1e-14);

        const boundBox box(body.points, false);
        EXPECT_TRUE(isWithin(triangles, box.midpoint()));
        EXPECT_FALSE(isWithin(triangles, box.midpoint() + box.span()));
    }
}


TEST(openComponents, closedBodyHasNoBorders)
{
    const List<openComponent> components
    (
        openComponents(merge(cube(1), translated(cube(1), vector(3, 0, 0))), {})
    );

    ASSERT_EQ(components.size(), 2);
    EXPECT_TRUE(components[0].borders.empty());
    EXPECT_TRUE(components[1].borders.empty());
}


// ************************************************************************* //
