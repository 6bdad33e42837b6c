/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "repairSurface.H"
#include "openSurfaces.H"
#include "wallDefects.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

typedef surfaceRepairControls::method method;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static wallSurfaceControls by(const method repair)
{
    wallSurfaceControls controls;
    controls.repair.repair = repair;

    return controls;
}


static void expectUntouched(const repairedSurface& r, const wallSurface& given)
{
    EXPECT_TRUE(r.steps.empty());
    EXPECT_EQ(r.surface.points, given.points);
    EXPECT_EQ(r.surface.faces, given.faces);
    EXPECT_EQ(r.surface.patchIDs, given.patchIDs);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(repairSurface, soundSurfaceIsUntouched)
{
    const wallSurface whole(duct(3));
    for (const method repair : {method::none, method::stitch, method::wrap})
    {
        expectUntouched(repairSurface(whole, by(repair)), whole);
    }

    wallSurfaceControls controls(by(method::stitch));
    controls.sidePlanes = halfPlanes();
    const wallSurface half(halfCube(4));
    expectUntouched(repairSurface(half, controls), half);
}


TEST(repairSurface, noneLeavesDefects)
{
    wallSurface surface(cube(2));
    surface.faces[0].flip();
    expectUntouched(repairSurface(surface, by(method::none)), surface);
}


TEST(repairSurface, stitchingKeepsPatchesAndTheSideOfTheFluid)
{
    wallSurface surface(duct(4));
    for (const label facei : {0, 17, 40})
    {
        surface.faces[facei].flip();
    }
    wallSurfaceControls controls(by(method::stitch));
    controls.fluidOutside = false;
    const repairedSurface r(repairSurface(surface, controls));

    EXPECT_TRUE(findWallDefects(r.surface).empty());
    EXPECT_NEAR(testSurfaces::enclosedVolume(r.surface), -1, 1e-12);
    EXPECT_EQ(r.surface.patchNames, surface.patchNames);
    ASSERT_EQ(r.surface.faces.size(), 96);
    EXPECT_LT(r.distance.largest, 1e-12);
    EXPECT_LT(r.distanceOfGiven.largest, 1e-12);

    labelList sizes(3, Zero);
    for (const label patchi : r.surface.patchIDs)
    {
        ++sizes[patchi];
    }
    EXPECT_EQ(sizes, labelList({64, 16, 16}));
}


TEST(repairSurface, openTubeIsCutAtBothEnds)
{
    // Whichever side its normals point to
    const wallSurface cube(quadCube(4));
    wallSurface tube(cube);
    tube.faces = subsetList(cube.faces, [&](const face& f)
    {
        return mag(f.unitNormal(cube.points).z()) < 0.5;
    });
    tube.patchIDs.setSize(tube.faces.size());
    wallSurfaceControls controls;
    controls.repair.repair = surfaceRepairControls::method::stitch;
    controls.sidePlanes =
    {
        symmetryPlane("low", point(0, 0, 0.3), vector(0, 0, -1)),
        symmetryPlane("high", point(0, 0, 0.8), vector(0, 0, 1))
    };

    for (const wallSurface& surface : {tube, reversed(tube)})
    {
        const wallSurface cut(repairSurface(surface, controls).surface);
        scalar area = 0;
        for (const face& f : cut.faces)
        {
            area += f.mag(cut.points);
        }

        EXPECT_NEAR(area, 4*0.5, 1e-12);
        EXPECT_TRUE(findWallDefects(cut, true).empty());
    }
}


TEST(repairSurface, bodiesThatTouchInAnEdgeAreUnitedOnceClosed)
{
    wallSurface surface(merge(cube(2), translated(cube(2), vector(1, 1, 0))));
    surface.faces.setSize(surface.faces.size() - 1);
    surface.patchIDs.setSize(surface.faces.size());
    wallSurfaceControls controls(by(method::stitch));
    controls.repair.hole = 1;
    const repairedSurface r(repairSurface(surface, controls));

    EXPECT_TRUE(findWallDefects(r.surface).empty());
    EXPECT_NEAR(testSurfaces::enclosedVolume(r.surface), 2, 1e-3);
}


TEST(repairSurface, wrapsWhatStitchingCannotClose)
{
    wallSurface surface(cube(3));
    surface.faces.setSize(surface.faces.size() - 6);
    surface.patchIDs.setSize(surface.faces.size());

    EXPECT_FALSE
    (
        findWallDefects
        (
            repairSurface(surface, by(method::stitch)).surface
        ).empty()
    );

    wallSurfaceControls controls(by(method::wrap));
    controls.repair.size = 0.8;
    controls.repair.offset = 0.02;
    const repairedSurface r(repairSurface(surface, controls));

    EXPECT_TRUE(findWallDefects(r.surface).empty());
    EXPECT_NEAR(testSurfaces::enclosedVolume(r.surface), 1, 0.1);
    EXPECT_GT(r.steps.size(), 1);
    EXPECT_LT(r.distanceOfGiven.mean, 0.02);
}


// ************************************************************************* //
