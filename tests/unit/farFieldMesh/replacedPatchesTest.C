/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "replacedPatches.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A row of unit squares above z = 0, the points of square i and its corners
face addSquare(const scalar x, const scalar width, pointField& points)
{
    const label first = points.size();
    points.append
    (
        pointField
        ({
            point(x, 0, 0), point(x + width, 0, 0),
            point(x + width, 1, 0), point(x, 1, 0)
        })
    );

    return face({first, first + 1, first + 2, first + 3});
}


//- A wall of squares, each a patch, without layers
prismLayers wallOfPatches(const wordList& names)
{
    prismLayers wall;
    wall.patchNames = names;
    wall.patchIDs = identity(names.size());
    forAll(names, i)
    {
        wall.faces.append(addSquare(i, 1, wall.points));
    }

    return wall;
}


//- A core of faces of given widths in a row, each a patch
polyMeshParts coreOfPatches(const wordList& names, const scalarList& widths)
{
    polyMeshParts core;
    scalar x = 0;
    forAll(names, i)
    {
        core.patches.append(names[i], "wall");
        core.topology.patchStarts.append(i);
        core.topology.patchSizes.append(1);
        core.topology.faces.append(addSquare(x, widths[i], core.points));
        x += widths[i];
    }

    return core;
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(replacedPatches, thePatchOnEachPatchOfTheWall)
{
    const wordList names({"hull", "deck"});

    EXPECT_EQ
    (
        replacedPatches
        (
            wallOfPatches({"a", "b"}), coreOfPatches(names, {1, 1}), names
        ),
        labelList({0, 1})
    );
}


TEST(replacedPatches, onlyPatchesOnTheWall)
{
    EXPECT_EQ
    (
        replacedPatches
        (
            wallOfPatches({"a", "b"}),
            coreOfPatches({"inlet", "deck"}, {1, 1}), {"deck"}
        ),
        labelList({-1, 1})
    );
}


TEST(replacedPatches, theLargestOfSeveralIfItIsMostOfThem)
{
    const wordList names({"hull", "rudder"});
    const prismLayers wall(wallOfPatches({"a"}));

    EXPECT_EQ
    (
        replacedPatches(wall, coreOfPatches(names, {0.7, 0.3}), names),
        labelList({0})
    );
    EXPECT_EQ
    (
        replacedPatches(wall, coreOfPatches(names, {0.5, 0.5}), names),
        labelList({-1})
    );
}


// ************************************************************************* //
