/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallChanges.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Two triangles on the edge from (0 0 0) to (2 0 0) in two patches; the apex
//  of the first is beside its middle
static wallSurface capOf(const scalar height, const scalar across = 0)
{
    wallSurface wall;
    wall.points = pointField
    ({
        point(0, 0, 0), point(2, 0, 0), point(1, height, across),
        point(1, -1, 0)
    });
    wall.faces = faceList({face({0, 1, 2}), face({1, 0, 3})});
    wall.patchIDs = labelList({0, 1});
    wall.patchNames = wordList({"a", "b"});

    return wall;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(flipCaps, flipsTheLongestEdge)
{
    for (const scalar across : {0.0, 1e-10, -1e-10})
    {
        wallSurface wall(capOf(1e-11, across));

        EXPECT_EQ(flipCaps(wall), 1);
        EXPECT_EQ(wall.faces[0], face({0, 3, 2}));
        EXPECT_EQ(wall.faces[1], face({3, 1, 2}));
        EXPECT_EQ(wall.patchIDs, labelList({1, 1}));
    }
}


TEST(flipCaps, trianglesWithHeightStay)
{
    wallSurface wall(capOf(1e-7));

    EXPECT_EQ(flipCaps(wall), 0);
    EXPECT_EQ(flipCaps(wall, 1e-6), 1);
}


TEST(flipCaps, needlesStay)
{
    wallSurface wall(capOf(1e-11));
    wall.points[2].x() = 2 + 1e-10;

    EXPECT_EQ(flipCaps(wall), 0);
}


TEST(flipCaps, edgesThatAreThereStay)
{
    wallSurface wall(capOf(1e-11));
    wall.points.append(point(1, 0, -1));
    wall.faces.append(face({2, 3, 4}));
    wall.patchIDs.append(label(0));

    EXPECT_EQ(flipCaps(wall), 0);
}


TEST(flipCaps, capsOnAFlatArcAreNotFlippedForEver)
{
    // Both diagonals of the four points make two caps
    wallSurface wall(capOf(1e-11));
    wall.points = pointField
    ({
        point(0, 0, 0), point(1, -1e-11, 0), point(2, -1e-11, 0), point(3, 0, 0)
    });
    wall.faces = faceList({face({0, 1, 2}), face({0, 2, 3})});

    EXPECT_LE(flipCaps(wall), 1);
}


TEST(flipCaps, twoCapsOnEachOther)
{
    // The neighbour of a cap is a cap, too
    wallSurface wall(capOf(1e-11));
    wall.points.append(point(0.5, -1e-11, 0));
    wall.faces[1] = face({1, 0, 4});
    wall.faces.append(face({0, 3, 4}));
    wall.faces.append(face({3, 1, 4}));
    wall.points.append(point(1, 1, 0));
    wall.faces.append(face({0, 2, 5}));
    wall.faces.append(face({2, 1, 5}));
    wall.patchIDs = labelList(6, 0);

    flipCaps(wall);

    vector sum(Zero);
    for (const face& f : wall.faces)
    {
        EXPECT_GT(f.areaNormal(wall.points).z(), 0.01);
        sum += f.areaNormal(wall.points);
    }
    EXPECT_NEAR(sum.z(), 2, 1e-9);
}


// ************************************************************************* //
