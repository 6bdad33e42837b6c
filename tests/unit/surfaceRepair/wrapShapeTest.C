/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wrapSurface.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wrapShape, flatTrianglesAreAtFaultAndTheOthersAreNot)
{
    wallSurface wrap(cube(2));
    const wallAddressing addressing(makeWallAddressing(wrap));
    const wrapShape shape(wrap, addressing);
    EXPECT_TRUE(shape.facesAtFault(wrap).empty());

    // A point in a side nearly onto one of its neighbours
    label p = 0;
    while (mag(wrap.points[p] - point(0.5, 0.5, 1)) > 1e-9)
    {
        ++p;
    }
    const point& beside = wrap.points[addressing.pointPoints[p][0]];
    wrap.points[p] = beside + 0.01*(wrap.points[p] - beside);
    const labelList atFault(shape.facesAtFault(wrap));

    EXPECT_FALSE(atFault.empty());
    for (const label facei : atFault)
    {
        EXPECT_GT(wrap.faces[facei].centre(wrap.points).z(), 1 - 1e-9);
    }
}


// ************************************************************************* //
