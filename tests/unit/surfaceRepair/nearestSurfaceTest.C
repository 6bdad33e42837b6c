/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearestSurface.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Two triangles on each side of x = 0, on z = slope y. The patch is "a" at
//  x < 0, "b" otherwise.
static wallSurface halves(const scalar width, const scalar slope)
{
    wallSurface surface;
    for (const scalar y : {-1, 1})
    {
        surface.points.append(point(-1, y, slope*y));
        surface.points.append(point(0, y, slope*y));
        surface.points.append(point(width, y, slope*y));
    }
    surface.faces = faceList
    ({
        face({0, 1, 4}), face({0, 4, 3}), face({1, 2, 5}), face({1, 5, 4})
    });
    surface.patchIDs = labelList({0, 0, 1, 1});
    surface.patchNames = wordList({"a", "b"});

    return surface;
}


//- The patches that a surface gets from the plane z = 0
static wordList patchesOf(wallSurface surface)
{
    const wallSurface given(halves(1, 0));
    nearestSurface(given).setPatches(surface, wordHashSet());

    wordList names;
    for (const label patchi : surface.patchIDs)
    {
        names.append(surface.patchNames[patchi]);
    }

    return names;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(nearestSurface, facesAlongTheGivenOnesHaveTheirPatches)
{
    EXPECT_EQ(patchesOf(halves(1.5, 0)), wordList({"a", "a", "b", "b"}));
    EXPECT_EQ(patchesOf(halves(1.5, 0.1)), wordList({"a", "a", "b", "b"}));
}


TEST(nearestSurface, aFlatPartAcrossTheGivenFacesHasOnePatch)
{
    EXPECT_EQ(patchesOf(halves(1.5, 0.5)), wordList(4, "b"));
    EXPECT_EQ(patchesOf(halves(0.5, 0.5)), wordList(4, "a"));
}


TEST(nearestSurface, partsWithAnEdgeBetweenThemHaveTwo)
{
    wallSurface roof(halves(1, 0.5));
    roof.points[1].z() += 0.5;
    roof.points[4].z() += 0.5;

    EXPECT_EQ(patchesOf(roof), wordList({"a", "a", "b", "b"}));
}


// ************************************************************************* //
