/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "innerPoint.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(innerPoint, ofATetrahedronIsTheCentreOfItsInnerSphere)
{
    const pointField x
    ({
        point(0, 0, 0), point(1, 0, 0), point(0, 1, 0), point(0, 0, 1)
    });
    const faceList triangles
    ({
        face({0, 2, 1}), face({0, 1, 3}), face({2, 0, 3}), face({1, 2, 3})
    });
    point inner;
    ASSERT_TRUE(findInnerPoint(triangles, x, inner));

    // The radius is the distance to all planes
    const scalar radius = 1/(3 + std::sqrt(scalar(3)));
    EXPECT_LT(mag(inner - point::uniform(radius)), 1e-12);
}


TEST(innerPoint, aTriangleWithoutAreaHasNone)
{
    const pointField x({point(0, 0, 0), point(1, 0, 0), point(2, 0, 0)});
    point inner;

    EXPECT_FALSE(findInnerPoint(faceList(1, face({0, 1, 2})), x, inner));
}


// ************************************************************************* //
