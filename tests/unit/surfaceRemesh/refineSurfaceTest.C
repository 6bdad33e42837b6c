/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farBoundary.H"
#include "refineSurface.H"
#include "openSurfaces.H"
#include "thrownMessage.H"
#include "triPointRef.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static farBoundary boundaryOf(const farBoundaryControls& controls)
{
    return makeFarBoundary
    (
        controls, [](const fileName& file) { return file; }
    );
}


static farBoundary boxBoundary(const point& low, const point& high)
{
    farBoundaryControls controls;
    controls.type = farBoundaryType::box;
    controls.box = boundBox(low, high);

    return boundaryOf(controls);
}


static scalar longestOverSize
(
    const wallSurface& surface,
    const std::function<scalar(const point&)>& size
)
{
    scalar longest = 0;

    for (const face& f : surface.faces)
    {
        forAll(f, k)
        {
            const edge e(f[k], f.nextLabel(k));
            longest = max
            (
                longest, e.mag(surface.points)/size(e.centre(surface.points))
            );
        }
    }

    return longest;
}


static scalarField qualities(const wallSurface& surface)
{
    scalarField values(surface.faces.size());

    forAll(values, facei)
    {
        const face& f = surface.faces[facei];
        values[facei] = triPointRef
        (
            surface.points[f[0]], surface.points[f[1]], surface.points[f[2]]
        ).quality();
    }

    return values;
}


static scalar worstQuality(const wallSurface& surface)
{
    return min(qualities(surface));
}


static scalar meanQuality(const wallSurface& surface)
{
    return average(qualities(surface));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(refineSurface, edgesAreAsShortAsTheSizes)
{
    wallSurface surface(boxBoundary(point(-1, -1, -1), point(9, 2, 1)).surface);
    const auto size = [](const point& x) { return 0.1 + 0.3*mag(x); };
    refineSurface(surface, size);

    EXPECT_LE(longestOverSize(surface, size), 1.5);
    EXPECT_GT(longestOverSize(surface, size), 1);
    EXPECT_TRUE(testSurfaces::isClosed(surface));
}


TEST(refineSurface, theSurfaceStaysWhereItIs)
{
    const wallSurface before
    (
        boxBoundary(point(-1, -1, -1), point(9, 2, 1)).surface
    );
    wallSurface surface(before);
    refineSurface(surface, [](const point&) { return 0.4; });

    EXPECT_NEAR
    (
        testSurfaces::enclosedVolume(surface),
        testSurfaces::enclosedVolume(before), 1e-12*60
    );

    scalarField areas(6, 0);
    forAll(surface.faces, facei)
    {
        areas[surface.patchIDs[facei]] +=
            surface.faces[facei].mag(surface.points);
    }
    const scalarField exact({6, 6, 20, 20, 30, 30});
    forAll(exact, side)
    {
        EXPECT_NEAR(areas[side], exact[side], 1e-12*exact[side]) << side;
    }
}


TEST(refineSurface, edgesWithOneFaceAreKept)
{
    // A cube without one square, shorter than its edges and much shorter
    for (const scalar size : {0.4, 0.1})
    {
        wallSurface surface(testSurfaces::quadCube(4, 4));
        surface.faces[5] = surface.faces.last();
        surface.faces.setSize(95);
        surface = testSurfaces::triangulated(surface);
        const edgeHashSet kept(outline(surface.faces));
        const pointField before(surface.points);
        refineSurface
        (
            surface, [=](const point&) { return size; }, nullptr,
            List<sidePatch>(), before.size()
        );

        EXPECT_EQ(kept.size(), 4);
        EXPECT_TRUE(edgeHashSet(outline(surface.faces)) == kept);
        for (const edge& e : kept)
        {
            EXPECT_EQ(surface.points[e.start()], before[e.start()]);
            EXPECT_EQ(surface.points[e.end()], before[e.end()]);
        }

        scalar area = 0;
        for (const face& f : surface.faces)
        {
            area += f.mag(surface.points);
        }
        EXPECT_NEAR(area, 95, 1e-11);

        // They are as short as the size, except near to the hole
        point centre(Zero);
        for (const edge& e : kept)
        {
            centre += 0.25*e.centre(before);
        }
        const auto ofSize = [=](const point& x)
        {
            return max(size, min(scalar(1), 1.2 - 0.25*mag(x - centre)));
        };
        EXPECT_LE(longestOverSize(surface, ofSize), 1.6);
        EXPECT_GT(surface.faces.size(), 95/sqr(2*size));
        EXPECT_GT(worstQuality(surface), 0.1);
    }
}


TEST(refineSurface, longEdgesWithOneFaceDoNotDivideWithoutEnd)
{
    wallSurface surface(testSurfaces::triangulated(testSurfaces::sheet(1, 0)));
    refineSurface(surface, [](const point&) { return 0.01; });

    // The diagonal is longer than the sides
    EXPECT_EQ(surface.faces.size(), 4);
}


TEST(refineSurface, trianglesOfABoxAreGood)
{
    wallSurface surface(boxBoundary(point(0, 0, 0), point(20, 2.3, 3)).surface);
    refineSurface(surface, [](const point&) { return 0.5; });
    EXPECT_GT(worstQuality(surface), 0.5);
}


TEST(refineSurface, longTrianglesBecomeBetter)
{
    // Two for each side of 1 x 20
    wallSurface surface(testSurfaces::cube(1));
    for (point& x : surface.points)
    {
        x.x() *= 20;
    }

    EXPECT_LT(meanQuality(surface), 0.35);
    refineSurface(surface, [](const point&) { return 0.3; });
    EXPECT_GT(meanQuality(surface), 0.8);
}


TEST(refineSurface, trianglesBesideAnEdgeAreGood)
{
    // A triangle is cut out of the lower side of a box, close to an edge
    wallSurface surface;
    surface.points = pointField
    ({
        point(0, 0, 0), point(10, 0, 0), point(10, 2, 0), point(0, 2, 0),
        point(0, 0, 2), point(10, 0, 2), point(10, 2, 2), point(0, 2, 2),
        point(1, 0.001, 0), point(1.1, 0.002, 0), point(1.05, 0.1, 0)
    });
    surface.faces = faceList
    ({
        face({0, 9, 1}), face({0, 8, 9}), face({1, 10, 2}), face({1, 9, 10}),
        face({2, 10, 3}), face({3, 10, 8}), face({3, 8, 0}),
        face({4, 5, 6}), face({4, 6, 7}), face({0, 1, 5}), face({0, 5, 4}),
        face({1, 2, 6}), face({1, 6, 5}), face({2, 3, 7}), face({2, 7, 6}),
        face({3, 0, 4}), face({3, 4, 7})
    });
    surface.patchIDs = labelList
    ({
        0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5
    });
    const point hole(surface.points[10]);
    const auto size = [&](const point& x) { return 0.1 + 0.2*mag(x - hole); };
    refineSurface(surface, size);

    const scalarField quality(qualities(surface));
    scalar worst = 1;
    forAll(quality, facei)
    {
        if (mag(surface.faces[facei].centre(surface.points) - hole) > 1)
        {
            worst = min(worst, quality[facei]);
        }
    }
    EXPECT_GT(worst, 0.3);
    EXPECT_EQ(outline(surface.faces).size(), 3);
    EXPECT_LE(longestOverSize(surface, size), 2.5);
}


TEST(refineSurface, pointsFollowASphere)
{
    farBoundaryControls controls;
    controls.type = farBoundaryType::sphere;
    controls.origin = point(1, 2, 3);
    controls.radius = 5;

    farBoundary boundary(boundaryOf(controls));
    refineSurface
    (
        boundary.surface, [](const point&) { return 0.8; }, boundary.project
    );

    for (const point& x : boundary.surface.points)
    {
        EXPECT_NEAR(mag(x - controls.origin), 5, 1e-12);
    }

    // Normals point inwards; a polyhedron in a sphere is smaller than that
    const scalar volume = testSurfaces::enclosedVolume(boundary.surface);
    EXPECT_LT(volume, -0.98*4/3.0*constant::mathematical::pi*125);
    EXPECT_TRUE(testSurfaces::isClosed(boundary.surface));
    EXPECT_EQ(testSurfaces::eulerCharacteristic(boundary.surface), 2);
    EXPECT_GT(worstQuality(boundary.surface), 0.5);
}


TEST(refineSurface, cyclicPatchesHaveEqualTriangles)
{
    // Finer at one of two sides that are images of each other
    wallSurface surface(boxBoundary(point(0, -1, -1), point(1, 2, 1)).surface);
    List<sidePatch> sides(2);
    sides[0].name = surface.patchNames[0];
    sides[0].normal = vector(-1, 0, 0);
    sides[0].cyclic.partner = sides[1].name = surface.patchNames[1];
    sides[1].normal = vector(1, 0, 0);
    sides[1].origin = point(1, 0, 0);
    sides[0].type = sides[1].type = "cyclic";
    const auto size = [](const point& x) { return 0.1 + 0.2*mag(x); };
    refineSurface(surface, size, nullptr, sides);

    EXPECT_TRUE(testSurfaces::isClosed(surface));
    EXPECT_GT(worstQuality(surface), 0.3);
    labelList nFaces(6, 0);
    pointField centres(2, point(Zero));
    forAll(surface.faces, facei)
    {
        const label patchi = surface.patchIDs[facei];
        ++nFaces[patchi];
        if (patchi < 2)
        {
            const point x(surface.faces[facei].centre(surface.points));
            centres[patchi] += cmptMultiply(x, x);
        }
    }
    EXPECT_EQ(nFaces[0], nFaces[1]);
    EXPECT_GT(nFaces[0], 100);
    EXPECT_NEAR(centres[0].y(), centres[1].y(), 1e-10);
    EXPECT_NEAR(centres[0].z(), centres[1].z(), 1e-10);
}


// ************************************************************************* //
