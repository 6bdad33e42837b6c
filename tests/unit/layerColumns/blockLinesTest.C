/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnLines.H"
#include "harmonicField.H"
#include "testLayers.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <omp.h>

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::stages;

//- Blocks of a few hundred points
static blockControls smallBlocks()
{
    blockControls controls;
    controls.maxPoints = 400;

    return controls;
}


//- Stages of a wall with a column on each point
struct dividedStages
:
    stages
{
    const layerFront front = testSurfaces::frontOf(wall, 0);

    using stages::stages;

    dividedWall divided() const
    {
        const blockControls controls(smallBlocks());

        return dividedWall
        {
            columnTeam::alone(), front, wall, radii, spacing,
            divideWall
            (
                wall.points, radii.radius, identity(wall.points.size()),
                controls
            ),
            controls
        };
    }
};


//- On the axes of the cones
static columnStarts startsOf(const stages& s)
{
    return columnStarts
    {
        identity(s.wall.points.size()), s.context.visibility.axes(), s.spacing
    };
}


static columnLines linesOfWhole(const stages& s)
{
    const backgroundMesh mesh(s.background());
    const monotoneField field
    (
        makeMonotoneField(mesh, cotangentWeights(mesh), fieldControls())
    );

    return makeColumnLines(mesh, field.values, startsOf(s));
}


//- Number of lines whose ends are further apart than 5 % of the thickness, or
//  whose slopes differ by more than 0.1
static label nApart
(
    const stages& s,
    const columnLines& a,
    const columnLines& b
)
{
    const label n = s.spacing.nLayers;
    label count = 0;
    forAll(a.slopes, c)
    {
        const label end = n*(c + 1) - 1;
        const scalar apart = mag(a.lines.points[end] - b.lines.points[end]);
        count += apart > 0.05*s.spacing.thickness[0]
         || mag(a.slopes[c] - b.slopes[c]) > 0.1;
    }

    return count;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(divideWall, everyPointIsOfOnePart)
{
    const stages s(testSurfaces::sphere(12), 4, 0.05);
    labelList some(identity(s.wall.points.size() - 7, 7));
    const labelListList parts
    (
        divideWall(s.wall.points, s.radii.radius, some, smallBlocks())
    );
    labelList nParts(s.wall.points.size(), 0);

    ASSERT_GT(parts.size(), 2);
    for (const labelList& part : parts)
    {
        EXPECT_LE(part.size(), smallBlocks().maxPoints);
        for (const label p : part)
        {
            ++nParts[p];
        }
    }
    labelList expected(nParts.size(), 0);
    UIndirectList<label>(expected, some) = 1;
    EXPECT_EQ(nParts, expected);
}


TEST(divideWall, narrowPartsStay)
{
    const stages s(testSurfaces::sphere(12), 4, 0.05);
    const blockControls controls(smallBlocks());
    const scalarField wide(s.wall.points.size(), 2/controls.reach);

    const labelList all(identity(wide.size()));
    EXPECT_EQ
    (
        divideWall(s.wall.points, wide, all, controls), labelListList({all})
    );
}


TEST(fieldBlock, hasAllFacesOfItsPoints)
{
    const dividedStages s(testSurfaces::torus(48, 24, 1, 0.4), 4, 0.05);
    const dividedWall wall(s.divided());
    ASSERT_GT(wall.blocks.size(), 2);

    for (const labelList& part : wall.blocks)
    {
        const fieldBlock block
        (
            makeFieldBlock
            (
                s.wall, s.radii, part, identity(s.wall.points.size()),
                wall.controls, wall.mesh
            )
        );
        EXPECT_LT(block.points.size(), s.wall.points.size());
        EXPECT_LT(block.envelope.points.size(), s.envelope.points.size());
        EXPECT_EQ(labelList(SubList<label>(block.points, block.nOwn)), part);
        EXPECT_EQ(block.wall.points, pointField(s.wall.points, block.points));

        for (label p = 0; p < block.nOwn; ++p)
        {
            EXPECT_TRUE(block.isWhole[p]);
            EXPECT_EQ
            (
                block.pointPoints[p].size(),
                s.context.addressing.pointPoints[part[p]].size()
            );
        }
        EXPECT_TRUE(block.isWhole.found(false));
    }
}


TEST(blockLines, areNearToThoseOfTheWholeField)
{
    const wallSurface ball(testSurfaces::sphere(12));
    const wallSurface shapes[] =
    {
        testSurfaces::torus(64, 32, 1, 0.4),
        testSurfaces::lBlock(12),
        testSurfaces::merge
        (
            ball, testSurfaces::translated(ball, vector(2.03, 0.1, 0.2))
        )
    };

    for (const wallSurface& shape : shapes)
    {
        const dividedStages s(shape, 6, 0.05);
        const dividedWall wall(s.divided());
        ASSERT_GT(wall.blocks.size(), 1);

        string failure;
        const columnLines blocks
        (
            makeColumnLines(wall, fieldControls(), failure)
        );
        const columnLines whole(linesOfWhole(s));

        EXPECT_EQ(failure, "");

        // Points in a plane have several Delaunay tetrahedralisations. TetGen
        // may take another one in a block, and a few lines are others then.
        EXPECT_LT(nApart(s, blocks, whole), 0.01*whole.slopes.size());
    }
}


TEST(blockLines, areTheSameOnAnyNumberOfThreads)
{
    const dividedStages s(testSurfaces::sphere(12), 4, 0.05);
    const dividedWall wall(s.divided());
    const label nThreads = omp_get_max_threads();
    string failure;
    List<columnLines> made;

    for (const label n : {1, 3})
    {
        omp_set_num_threads(n);
        made.append
        (
            makeColumnLines(wall, fieldControls(), failure)
        );
        EXPECT_EQ(failure, "");
    }
    omp_set_num_threads(nThreads);

    EXPECT_EQ(made[0].lines.points, made[1].lines.points);
    EXPECT_EQ(made[0].lines.energies, made[1].lines.energies);
    EXPECT_EQ(made[0].slopes, made[1].slopes);
}


TEST(blockLines, areStraightWhereBlocksFail)
{
    const wallSurface ball(testSurfaces::sphere(12));
    const dividedStages s
    (
        testSurfaces::merge
        (
            ball, testSurfaces::translated(ball, vector(0.9, 0.1, 0.2))
        ),
        4, 0.02
    );
    const columnStarts starts(startsOf(s));
    string failure;
    const columnLines made
    (
        makeColumnLines(s.divided(), fieldControls(), failure)
    );

    EXPECT_NE(failure.find("TetGen"), std::string::npos) << failure;
    EXPECT_NE(failure.find(" blocks of the wall, "), std::string::npos);
    const pointField straight
    (
        makeStraightLines
        (
            s.wall.points, starts.directions, requestedHeights(s.spacing)
        ).points
    );
    label nStraight = 0;
    forAll(made.slopes, c)
    {
        nStraight += made.slopes[c] == 0;
        for (label i = 0; i < 4 && made.slopes[c] == 0; ++i)
        {
            EXPECT_EQ(made.lines.points[4*c + i], straight[4*c + i]);
        }
    }
    EXPECT_GT(nStraight, 0);
    EXPECT_LT(nStraight, made.slopes.size());
}


// ************************************************************************* //
