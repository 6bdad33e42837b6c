/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "offsetEnvelope.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(envelopeRays, flatPointHasOneRayAndACornerOneAlongEachNormal)
{
    const wallSurface wall(cube(2));
    const wallContext context(wall);
    const scalarField wanted(wall.points.size(), 0.1);

    forAll(wall.points, p)
    {
        envelopeRays rays(context, wanted, 2);
        rays.addPoint(p, 0.1);

        // On how many sides of the cube the point is
        label nSides = 0;
        for (direction d = 0; d < 3; ++d)
        {
            nSides += mag(wall.points[p][d] - 0.5) > 0.4;
        }
        EXPECT_EQ(rays.all().size(), nSides == 1 ? 1 : 1 + nSides);
        EXPECT_FALSE(rays.isLimited(p, rays.all()[0].radius));
    }
}


TEST(envelopeRays, edgesThatAreLongForTheRadiusHaveRays)
{
    const wallSurface wall(cube(1));
    const wallContext context(wall);
    const scalarField wanted(wall.points.size(), 1);
    envelopeRays shortEdges(context, wanted, 2), longEdges(context, wanted, 2);
    shortEdges.addLongEdges(0, 1);
    longEdges.addLongEdges(0, 0.1);

    EXPECT_EQ(shortEdges.all().size(), 0);
    EXPECT_EQ(longEdges.all().size(), context.addressing.pointPoints[0].size());
    for (const envelopeRay& ray : longEdges.all())
    {
        EXPECT_TRUE(ray.outerOnly);
    }
}


// ************************************************************************* //
