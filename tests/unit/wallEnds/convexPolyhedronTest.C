/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "convexPolyhedron.H"
#include "openSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using testSurfaces::symmetryPlane;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const boundBox unitBox(point(0, 0, 0), point(1, 1, 1));


static convexPolyhedron cutOf
(
    const boundBox& box,
    const List<sidePatch>& planes
)
{
    return cutBox(box, planes);
}


//- Of faces that are seen from inside
static scalar volumeOf(const convexPolyhedron& cut)
{
    wallSurface surface;
    surface.points = cut.points;
    surface.faces = cut.faces;
    EXPECT_TRUE(testSurfaces::isClosed(surface));

    return -testSurfaces::enclosedVolume(surface);
}


static label nFacesOf(const convexPolyhedron& cut, const label plane)
{
    label n = 0;
    forAll(cut.planes, facei)
    {
        EXPECT_NE(cut.planes[facei] < 0, cut.boxSides[facei] < 0);
        n += cut.planes[facei] == plane;
    }

    return n;
}


static sidePatch oblique(const scalar distance, const scalar sign)
{
    const vector n(normalised(vector(1, 1, 1)));

    return symmetryPlane("oblique", distance*n, sign*n);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(convexPolyhedron, withoutPlanesIsTheBox)
{
    const convexPolyhedron cut(cutOf(unitBox, {}));

    EXPECT_NEAR(volumeOf(cut), 1, 1e-15);
    EXPECT_EQ(cut.boxSides, identity(6));
    EXPECT_EQ(cut.planes, labelList(6, -1));

    forAll(cut.faces, facei)
    {
        vector inward(Zero);
        inward[facei/2] = facei % 2 ? -1 : 1;
        EXPECT_EQ(cut.faces[facei].areaNormal(cut.points), inward);
    }
}


TEST(convexPolyhedron, halfOfABox)
{
    const convexPolyhedron cut
    (
        cutOf
        (
            unitBox, {symmetryPlane("x", point(0.25, 7, 7), vector(-1, 0, 0))}
        )
    );

    EXPECT_NEAR(volumeOf(cut), 0.75, 1e-15);
    EXPECT_EQ(cut.faces.size(), 6);
    EXPECT_EQ(nFacesOf(cut, 0), 1);
    // The side at x = 0 is gone
    EXPECT_FALSE(cut.boxSides.found(0));
}


TEST(convexPolyhedron, cornerAndWhatIsLeftOfTheBox)
{
    // The plane x + y + z = 1/2
    const scalar distance = 0.5/::sqrt(3.0);
    const convexPolyhedron corner(cutOf(unitBox, {oblique(distance, 1)}));
    const convexPolyhedron rest(cutOf(unitBox, {oblique(distance, -1)}));

    EXPECT_NEAR(volumeOf(corner), 1.0/48, 1e-15);
    EXPECT_EQ(corner.faces.size(), 4);
    EXPECT_EQ(nFacesOf(corner, 0), 1);

    EXPECT_NEAR(volumeOf(rest), 47.0/48, 1e-15);
    EXPECT_EQ(rest.faces.size(), 7);
    EXPECT_EQ(nFacesOf(rest, 0), 1);
    EXPECT_EQ(nFacesOf(rest, -1), 6);
}


TEST(convexPolyhedron, hexagonThroughTheMiddle)
{
    const convexPolyhedron cut
    (
        cutOf(unitBox, {oblique(1.5/::sqrt(3.0), 1)})
    );

    EXPECT_NEAR(volumeOf(cut), 0.5, 1e-15);
    EXPECT_EQ(cut.faces[cut.planes.find(0)].size(), 6);
}


TEST(convexPolyhedron, quarterByTwoPlanes)
{
    const convexPolyhedron cut
    (
        cutOf
        (
            unitBox,
            {
                symmetryPlane("y", point::uniform(0.5), vector(0, -1, 0)),
                symmetryPlane("z", point::uniform(0.5), vector(0, 0, -1))
            }
        )
    );

    EXPECT_NEAR(volumeOf(cut), 0.25, 1e-15);
    EXPECT_EQ(nFacesOf(cut, 0), 1);
    EXPECT_EQ(nFacesOf(cut, 1), 1);
    EXPECT_EQ(nFacesOf(cut, -1), 4);
}


TEST(convexPolyhedron, sideInAPlaneIsThePlanes)
{
    // In the plane to rounding
    for (const scalar off : {0.0, 1e-12, -1e-12})
    {
        const convexPolyhedron cut
        (
            cutOf
            (
                unitBox,
                {symmetryPlane("low", point(0, 0, off), vector(0, 0, -1))}
            )
        );

        EXPECT_NEAR(volumeOf(cut), 1, 1e-11);
        EXPECT_EQ(cut.faces.size(), 6);
        EXPECT_EQ(nFacesOf(cut, 0), 1);
        EXPECT_EQ(cut.boxSides[4], -1);
        EXPECT_EQ(cut.planes[4], 0);
    }
}


TEST(convexPolyhedron, planeThatMissesTheBoxCutsNothing)
{
    // Beside the box, and at one of its edges
    for (const scalar distance : {-1.0, 0.0})
    {
        const vector n(normalised(vector(-1, -1, 0)));
        const convexPolyhedron cut
        (
            cutOf(unitBox, {symmetryPlane("away", distance*-n, n)})
        );

        EXPECT_EQ(cut.faces.size(), 6);
        EXPECT_NEAR(volumeOf(cut), 1, 1e-15);
        EXPECT_EQ(nFacesOf(cut, 0), 0);
    }
}


TEST(convexPolyhedron, partsOfPlanesDoNotCut)
{
    sidePatch part(symmetryPlane("x", point(0.5, 0, 0), vector(-1, 0, 0)));
    part.points = pointField({{0.5, 0, 0}, {0.5, 1, 0}, {0.5, 0, 1}});
    part.faces = faceList(1, face({0, 1, 2}));

    EXPECT_NEAR(volumeOf(cutOf(unitBox, {part})), 1, 1e-15);
}


TEST(convexPolyhedron, flatAndFarBoxesAreCut)
{
    const point low(1000, -2000, 500);
    const boundBox box(low, low + vector(1, 1, 1e-3));
    const convexPolyhedron cut
    (
        cutOf
        (
            box, {symmetryPlane("x", low + point(0.25, 0, 0), vector(-1, 0, 0))}
        )
    );

    EXPECT_EQ(cut.faces.size(), 6);
    EXPECT_NEAR(boundBox(cut.points).min().x(), low.x(), 1e-9);
    EXPECT_EQ(nFacesOf(cut, 0), 1);
}


// ************************************************************************* //
