/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnLines.H"
#include "testLayers.H"
#include "testStages.H"
#include "testSurfaces.H"
#include "threadTeam.H"
#include "wallBlocks.H"

#include <gtest/gtest.h>

#include <mutex>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::stages;

//- What a process has of the stages of a whole wall
struct shareOfStages
{
    const frontShare share;
    const columnTeam team;
    const List<pointKind> kinds;
    const scalarField curvature;
    const wallUnderShare under;
    const envelopeRadii radii;
    const layerSpacing spacing;

    shareOfStages
    (
        const stages& s,
        const layerFront& front,
        const label n,
        const threadTeam& processes
    )
    :
        share
        (
            shareOf
            (
                front, ownersByRange(s.wall.points.size(), n), n,
                processes.rank()
            )
        ),
        team(share, processes),
        kinds(UIndirectList<pointKind>(s.context.kinds, share.points.whole)),
        curvature
        (
            testSurfaces::wallOfOne(s.wall).curvature, share.points.whole
        ),
        under(share.front, kinds, curvature),
        radii
        (
            makeEnvelopeRadii
            (
                under.wall, under.addressing,
                scalarField(s.radii.wanted, share.points.whole),
                scalarField(s.clearance, share.points.whole), team
            )
        ),
        spacing(s.spacing.at(share.points.whole))
    {}
};


//- Calls work for the shares of n processes
static void onShares
(
    const stages& s,
    const label n,
    const scalar angle,
    const std::function<void(const shareOfStages&)>& work
)
{
    const layerFront front(testSurfaces::frontOf(s.wall, angle));
    threadTeam::run(n, [&](const threadTeam& processes)
    {
        work(shareOfStages(s, front, n, processes));
    });
}


//- Two balls, of which one limits the room of the other: radii have slopes
static stages twoBalls()
{
    const wallSurface ball(testSurfaces::sphere(12));

    return stages
    (
        testSurfaces::merge
        (
            ball, testSurfaces::translated(ball, vector(2.03, 0.1, 0.2))
        ),
        6, 0.05
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sharedBlocks, radiiAreThoseOfTheWholeWall)
{
    const stages s(twoBalls());
    std::mutex reporting;
    for (const label n : {2, 5})
    {
        onShares(s, n, 0, [&](const shareOfStages& own)
        {
            const envelopeRadii whole(s.radii.at(own.share.points.whole));
            const std::lock_guard<std::mutex> lock(reporting);
            EXPECT_EQ(own.radii.wanted, whole.wanted);
            EXPECT_EQ(own.radii.room, whole.room);
            EXPECT_EQ(own.radii.radius, whole.radius);
            EXPECT_EQ(own.radii.edgeLengths, whole.edgeLengths);
        });
    }
}


TEST(sharedBlocks, islandsAreThoseOfTheWholeWall)
{
    const stages s(testSurfaces::lBlock(12), 4, 0.05);
    const labelList islands
    (
        findFieldIslands(testSurfaces::wallOfOne(s.wall).under, s.radii)
    );
    ASSERT_GT(islands.size(), 0);
    ASSERT_LT(islands.size(), s.wall.points.size());

    std::mutex reporting;
    label nFound = 0;
    onShares(s, 5, 0, [&](const shareOfStages& own)
    {
        const labelList found
        (
            findFieldIslands(own.under, own.radii, own.team)
        );
        const std::lock_guard<std::mutex> lock(reporting);
        for (const label p : found)
        {
            nFound += own.team.isOwn(p);
            EXPECT_TRUE(islands.found(own.team.wholeColumn(p)));
        }
    });
    EXPECT_EQ(nFound, islands.size());
}


TEST(sharedBlocks, partsOfTheWallHaveAllFacesInTheirBoxes)
{
    const stages s(testSurfaces::sphere(8), 4, 0.05);
    std::mutex reporting;
    onShares(s, 4, 0, [&](const shareOfStages& own)
    {
        const point corner(0.2*own.team.rank(), 0, 0);
        const List<boundBox> boxes
        ({
            boundBox(corner, corner + point::uniform(0.5)),
            boundBox(-corner - point::uniform(0.5), -corner)
        });
        const surfacePart part
        (
            wallPartInBoxes(own.share.front, own.team, boxes)
        );
        labelHashSet inside(facesIn(s.wall, boxes[0]));
        inside.insert(facesIn(s.wall, boxes[1]));
        const surfacePart whole(makeSurfacePart(s.wall, inside.sortedToc()));

        const std::lock_guard<std::mutex> lock(reporting);
        EXPECT_EQ(part.points, whole.points);
        EXPECT_EQ(part.faces, whole.faces);
        EXPECT_EQ(part.surface.points, whole.surface.points);
        EXPECT_EQ(part.surface.faces, whole.surface.faces);
        EXPECT_EQ(part.surface.patchIDs, whole.surface.patchIDs);
    });
}


static columnLines linesOfOneProcess
(
    const stages& s,
    const layerFront& front,
    const labelListList& parts,
    const blockControls& controls
)
{
    string failure;
    const columnLines lines
    (
        makeColumnLines
        (
            dividedWall
            {
                columnTeam::alone(), front, s.wall, s.radii, s.spacing, parts,
                controls
            },
            fieldControls(), failure
        )
    );
    EXPECT_EQ(failure, "");

    return lines;
}


//- Expects of processes the lines of one process, bit for bit
static void expectSameLines(const stages& s, const scalar angle)
{
    blockControls controls;
    controls.maxPoints = 400;
    const layerFront front(testSurfaces::frontOf(s.wall, angle));
    const labelListList parts
    (
        divideWall
        (
            s.wall.points, s.radii.radius, identity(s.wall.points.size()),
            controls
        )
    );
    ASSERT_GT(parts.size(), 2);

    const columnLines whole(linesOfOneProcess(s, front, parts, controls));
    std::mutex reporting;
    label nDifferent = 0, nSet = 0;
    onShares(s, 3, angle, [&](const shareOfStages& own)
    {
        string failureHere;
        const columnLines lines
        (
            makeColumnLines
            (
                dividedWall
                {
                    own.team, own.share.front, own.under.wall, own.radii,
                    own.spacing, parts, controls
                },
                fieldControls(), failureHere
            )
        );
        const label n = whole.lines.nSamples;

        const std::lock_guard<std::mutex> lock(reporting);
        EXPECT_EQ(failureHere, "");
        forAll(lines.isSet, c)
        {
            const label w = own.share.columns.whole[c];
            EXPECT_EQ(lines.isSet[c], own.share.columns.isOwn[c]);
            nSet += lines.isSet[c];
            nDifferent += lines.isSet[c] && lines.slopes[c] != whole.slopes[w];
            for (label i = 0; i < n && lines.isSet[c]; ++i)
            {
                nDifferent +=
                    lines.lines.points[n*c + i] != whole.lines.points[n*w + i];
            }
        }
    });
    EXPECT_EQ(nSet, front.wallPoints.size());
    EXPECT_EQ(nDifferent, 0);
}


TEST(sharedBlocks, linesAreThoseOfOneProcess)
{
    expectSameLines(stages(testSurfaces::torus(48, 24, 1, 0.4), 4, 0.05), 0);
    expectSameLines(twoBalls(), 0);
}


TEST(sharedBlocks, linesOfSeveralColumnsOnAPoint)
{
    expectSameLines(stages(testSurfaces::cube(14), 4, 0.02), 60);
}


// ************************************************************************* //
