/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "orientOpenWall.H"
#include "boundBox.H"
#include "openSurfaces.H"
#include "surfacePart.H"

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
        EXPECT_EQ(components[0].corners().size(), 2*(nPlanes - 1));

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


TEST(openComponents, capsCloseABodyBetweenTwoWalls)
{
    // On the ground, too: no point is in all three planes
    wallSurface body(halfCube(4));
    bitSet kept(body.faces.size());
    forAll(body.faces, facei)
    {
        const scalar y = body.faces[facei].centre(body.points).y();
        kept.set(facei, y > 0 && y < 1);
    }
    keepFaces(kept, body);
    List<sidePatch> planes(halfPlanes());
    planes.append(symmetryPlane("left", Zero, vector(0, -1, 0)));
    planes.append(symmetryPlane("right", vector(0, 1, 0), vector(0, 1, 0)));

    const List<openComponent> components(openComponents(body, planes));
    ASSERT_EQ(components.size(), 1);
    EXPECT_EQ(components[0].corners().size(), 4);
    const List<triPoints> triangles
    (
        cappedTriangles(body, planes, components[0])
    );
    EXPECT_NEAR(volumeOf(triangles), 0.5, 1e-14);
    EXPECT_TRUE(isWithin(triangles, point(0.5, 0.5, 0.25)));
    EXPECT_FALSE(isWithin(triangles, point(0.5, 0.5, 0.75)));

    wallSurface inverted(reversed(body));
    EXPECT_EQ(orientOpenWall(inverted, planes, true), body.faces.size());
    EXPECT_EQ
    (
        inverted.faces[0].unitNormal(inverted.points),
        body.faces[0].unitNormal(body.points)
    );
    EXPECT_EQ(orientOpenWall(inverted, planes, true), 0);
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
