/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "remeshSurface.H"
#include "surfaceMeasures.H"
#include "wallDefects.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static surfaceRemeshControls lengths
(
    const scalar maxEdge,
    const scalar minEdge,
    const scalar deviation
)
{
    surfaceRemeshControls controls;
    controls.maxEdge = maxEdge;
    controls.minEdge = minEdge;
    controls.deviation = deviation;

    return controls;
}


//- The longest edge
static scalar longestEdge(const wallSurface& surface)
{
    scalar longest = 0;
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            longest = max(longest, e.mag(surface.points));
        }
    }

    return longest;
}


//- A cylinder about z, as CAD exports it: needles along it, fans at its ends
static wallSurface cadCylinder(const label n)
{
    wallSurface surface;
    surface.patchNames = {"wall"};
    const label low = 2*n;
    const label high = 2*n + 1;
    DynamicList<face> faces;

    for (const scalar z : {0.0, 4.0})
    {
        for (label i = 0; i < n; ++i)
        {
            const scalar a = constant::mathematical::twoPi*i/n;
            surface.points.append(point(Foam::cos(a), Foam::sin(a), z));
        }
    }
    surface.points.append(point(0, 0, 0));
    surface.points.append(point(0, 0, 4));

    for (label i = 0; i < n; ++i)
    {
        const label j = (i + 1) % n;
        faces.append(face({i, j, n + j}));
        faces.append(face({i, n + j, n + i}));
        faces.append(face({j, i, low}));
        faces.append(face({n + i, n + j, high}));
    }
    surface.faces = std::move(faces);
    surface.patchIDs = labelList(surface.faces.size(), 0);

    return surface;
}


static void expectGood(const wallSurface& surface, const scalar angle)
{
    EXPECT_TRUE(findWallDefects(surface, true).empty());
    EXPECT_GT(measuresOf(surface).smallestAngle, angle);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(remeshSurface, needlesBecomeNearToRegular)
{
    const wallSurface surface(cadCylinder(60));
    EXPECT_LT(measuresOf(surface).smallestAngle, 2);

    const wallSurface result
    (
        remeshSurface(surface, lengths(0.3, 0.05, 2e-3)).surface
    );

    expectGood(result, 20);
    EXPECT_LT(longestEdge(result), 1.5*0.3);
    EXPECT_NEAR
    (
        testSurfaces::enclosedVolume(result),
        testSurfaces::enclosedVolume(surface),
        1e-2*testSurfaces::enclosedVolume(surface)
    );
}


TEST(remeshSurface, keepsAllOfACube)
{
    const wallSurface surface(cube(1));
    const remeshedSurface result
    (
        remeshSurface(surface, lengths(0.15, 0.05, 1e-3))
    );

    expectGood(result.surface, 25);
    EXPECT_LT(result.distance.largest, 1e-12);
    EXPECT_LT(result.distanceOfGiven.largest, 1e-12);
    EXPECT_NEAR(testSurfaces::enclosedVolume(result.surface), 1, 1e-12);
    EXPECT_LT(longestEdge(result.surface), 1.5*0.15);
}


TEST(remeshSurface, coarsensWithinTheDeviation)
{
    const wallSurface surface(sphere(60));
    const remeshedSurface result
    (
        remeshSurface(surface, lengths(1, 0.01, 5e-3))
    );

    expectGood(result.surface, 20);
    EXPECT_LT(3*result.surface.faces.size(), surface.faces.size());
    EXPECT_LT(result.distance.largest, 5e-3);
    EXPECT_LT(result.distanceOfGiven.largest, 5e-3);

    // Half the deviation asks for about twice the triangles
    const label nFiner =
        remeshSurface(surface, lengths(1, 0.01, 2.5e-3))
       .surface.faces.size();
    EXPECT_GT(nFiner, 1.5*result.surface.faces.size());
    EXPECT_LT(nFiner, 2.7*result.surface.faces.size());
}


TEST(remeshSurface, keepsBordersOfPatches)
{
    wallSurface surface(cube(2));
    surface.patchNames = {"wall", "inlet"};
    const vectorField normals(surface.faceNormals());
    forAll(surface.faces, facei)
    {
        surface.patchIDs[facei] = normals[facei].x() < -0.5 ? 1 : 0;
    }

    const wallSurface result
    (
        remeshSurface(surface, lengths(0.2, 0.05, 1e-3)).surface
    );
    scalar area = 0;
    forAll(result.faces, facei)
    {
        const face& f = result.faces[facei];
        if (result.patchIDs[facei] == 1)
        {
            area += f.mag(result.points);
            for (const label p : f)
            {
                EXPECT_NEAR(result.points[p].x(), 0, 1e-14);
            }
        }
    }
    EXPECT_NEAR(area, 1, 1e-12);
}


TEST(remeshSurface, anOpenBorderStaysWhereItIs)
{
    const wallSurface result
    (
        remeshSurface(halfSphere(16), lengths(0.3, 0.02, 2e-3)).surface
    );

    expectGood(result, 15);
    label nOnPlane = 0;
    for (const point& x : result.points)
    {
        EXPECT_GT(x.z(), -1e-14);
        nOnPlane += mag(x.z()) < 1e-14;
    }
    EXPECT_GT(nOnPlane, 10);
}


TEST(remeshSurface, keepsQuadrilateralsWithinTheBounds)
{
    const wallSurface surface(quadCube(4));

    EXPECT_EQ
    (
        remeshSurface(surface, lengths(0.3, 0.1, 1e-3)).surface.faces,
        surface.faces
    );

    const wallSurface result
    (
        remeshSurface(surface, lengths(0.15, 0.1, 1e-3)).surface
    );
    for (const face& f : result.faces)
    {
        EXPECT_EQ(f.size(), 3);
    }
}


TEST(remeshSurface, thinBodiesDoNotIntersectThemselves)
{
    // A shell much thinner than the deviation that is allowed
    const wallSurface surface
    (
        merge(sphere(24, 1), reversed(sphere(24, 0.995)))
    );
    const wallSurface result
    (
        remeshSurface(surface, lengths(0.5, 0.1, 2e-2)).surface
    );

    EXPECT_TRUE(findWallDefects(result).empty());
    EXPECT_GT(testSurfaces::enclosedVolume(result), 0);
}


// ************************************************************************* //
