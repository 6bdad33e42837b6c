/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "sideParts.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(splitAtEdges, facesOnBothSidesOfAnEdgeShareItsPoint)
{
    // Two triangles, the second one of both on the other side of the edge
    wallSurface surface(unequalTriangles());
    const label x = surface.points.size();
    surface.points.append(point(0.5, 0, 0));
    EdgeMap<label> points;
    points.insert(edge(0, 1), x);

    scalar area = 0;
    for (const face& f : surface.faces)
    {
        area -= f.mag(surface.points);
    }
    EXPECT_EQ(splitAtEdges(points, surface), labelList({0, 1}));

    ASSERT_EQ(surface.faces.size(), 4);
    EXPECT_EQ(surface.patchIDs, labelList(4, Zero));
    for (const face& f : surface.faces)
    {
        EXPECT_TRUE(f.found(x));
        EXPECT_GT(f.areaNormal(surface.points).z(), 0);
        area += f.mag(surface.points);
    }
    EXPECT_NEAR(area, 0, 1e-15);
}


// ************************************************************************* //
