/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxSides.H"
#include "openSurfaces.H"
#include "planeDomain.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The sides of the unit cube
static List<sidePlane> cubePlanes()
{
    const List<sidePatch> sides(sidesOf(boundBox(Zero, vector(1, 1, 1))));

    List<sidePlane> planes(sides.size());
    std::copy(sides.begin(), sides.end(), planes.begin());

    return planes;
}


static scalar volumeOf(const wallSurface& wall)
{
    const endedSurface surface
    {
        wall.points, wall.faces, wall.border.edges, wall.border.edgeSides
    };
    const List<sidePlane> planes
    (
        wall.border.sides.begin(), wall.border.sides.end()
    );

    return volumeOf(surface, planes);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(planeDomain, aCornerOfACubeIsCutOff)
{
    List<sidePlane> planes(cubePlanes());
    EXPECT_NEAR(volumeOf(planes), 1, 1e-12);

    sidePlane corner;
    corner.normal = normalised(vector(1, 1, 1));
    corner.origin = vector(1, 1, 0.5);
    planes.append(corner);
    EXPECT_NEAR(volumeOf(planes), 1 - 1.0/48, 1e-12);

    const scalarField areas(areasOf(planes));
    EXPECT_NEAR(areas[0], 1, 1e-12);
    EXPECT_NEAR(areas[1], 1 - 1.0/8, 1e-12);
    EXPECT_NEAR(areas[6], Foam::sqrt(3.0)/8, 1e-12);
}


TEST(planeDomain, surfacesAreCappedByThePlanesOnWhichTheyEnd)
{
    const wallSurface half
    (
        testSurfaces::endedOn
        (
            testSurfaces::halfSphere(6), testSurfaces::halfPlanes()
        )
    );
    EXPECT_NEAR(volumeOf(half), testSurfaces::volumeTo(half, Zero), 1e-12);

    const wallSurface quarter
    (
        testSurfaces::endedOn
        (
            testSurfaces::quarterCube(4), testSurfaces::quarterPlanes()
        )
    );
    const endedSurface surface
    {
        quarter.points, quarter.faces, quarter.border.edges,
        quarter.border.edgeSides
    };
    EXPECT_NEAR(volumeOf(quarter), 0.25, 1e-12);
    EXPECT_NEAR
    (
        capArea(surface, quarter.border.sides[0], 0, Zero), 0.5, 1e-12
    );
    EXPECT_FALSE(boundsFluid(quarter));
}


TEST(planeDomain, parallelPlanesHaveNoCommonPoint)
{
    // A cube without its ends in x
    wallSurface beam(testSurfaces::quadCube(1));
    DynamicList<face> faces;
    for (const face& f : beam.faces)
    {
        if (mag(f.areaNormal(beam.points).x()) < 0.1)
        {
            faces.append(f);
        }
    }
    beam.faces.transfer(faces);
    beam.patchIDs.setSize(beam.faces.size());
    const List<sidePatch> planes
    ({
        testSurfaces::symmetryPlane("low", Zero, vector(-1, 0, 0)),
        testSurfaces::symmetryPlane("high", vector(1, 0, 0), vector(1, 0, 0))
    });

    EXPECT_NEAR(volumeOf(testSurfaces::endedOn(beam, planes)), 1, 1e-12);
}


TEST(planeDomain, surfacesTurnedInsideOutBoundTheFluid)
{
    const wallSurface cube(testSurfaces::quadCube(2));
    EXPECT_FALSE(boundsFluid(cube));
    EXPECT_TRUE(boundsFluid(testSurfaces::reversed(cube)));
}


// ************************************************************************* //
