/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeHexCore.H"
#include "partsMesh.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A box with the patches low, on three sides, and high
static hexCoreBox boxTo(const point& max)
{
    hexCoreBox box;
    box.box = boundBox(point::uniform(-1), max);
    box.patches.append("low", "patch");
    box.patches.append("high", "wall");
    box.sidePatches = labelList({0, 1, 0, 1, 0, 1});

    return box;
}


//- A body that is small, or behind whose surface a box is
static const wallSearch& body()
{
    static const wallSurface sphere(testSurfaces::sphere(4, 0.3));
    static const wallSearch search(sphere);

    return search;
}


static polyMeshParts filled
(
    const hexCoreBox& box,
    const std::function<scalar(const point&)>& size,
    const label maxCells = 100000
)
{
    return makeHexCore(box, coreObstacles{body(), body()}, size, maxCells);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(makeHexCore, oneHexahedronFillsACube)
{
    // Of another body, which is elsewhere
    const wallSurface sphere
    (
        testSurfaces::translated(testSurfaces::sphere(4, 0.3), vector(9, 0, 0))
    );
    const wallSearch search(sphere);
    const polyMeshParts parts
    (
        makeHexCore
        (
            boxTo(point::uniform(1)), coreObstacles{search, search},
            [](const point&) { return scalar(10); }, 10
        )
    );

    EXPECT_EQ(parts.nCells, 1);
    EXPECT_EQ(parts.points.size(), 8);
    EXPECT_EQ(parts.topology.faces.size(), 6);
    EXPECT_EQ(parts.topology.patchSizes, labelList({3, 3, 0}));
    EXPECT_TRUE(parts.cellZones.empty());
    expectSound(partsMesh(parts)());
}


TEST(makeHexCore, hangingPointsAreOnAllFacesAround)
{
    // Fine at one edge of the box and at the body
    const polyMeshParts parts
    (
        filled
        (
            boxTo(point(2, 1, 1)),
            [](const point& x)
            {
                return 0.05 + 0.4*mag(point(x.x() - 2, x.y() - 1, 0));
            }
        )
    );
    const partsMesh memory(parts);
    const polyMesh& mesh = memory();

    EXPECT_FALSE(mesh.checkCellsZipUp(false));
    EXPECT_FALSE(mesh.checkTopology(false));
    EXPECT_FALSE(mesh.checkUpperTriangular(false));
    EXPECT_FALSE(mesh.checkClosedCells(false));
    EXPECT_FALSE(mesh.checkFacePyramids(false));

    label nWithHanging = 0;
    for (const face& f : mesh.faces())
    {
        EXPECT_LE(f.size(), 8);
        nWithHanging += f.size() > 4;
    }
    EXPECT_GT(nWithHanging, 0);

    // Widths differ by a factor of two at most
    const scalarField widths(cbrt(mesh.cellVolumes()));
    forAll(mesh.faceNeighbour(), facei)
    {
        const scalar a = widths[mesh.faceOwner()[facei]];
        const scalar b = widths[mesh.faceNeighbour()[facei]];
        EXPECT_LT(max(a, b), 2.001*min(a, b));
    }
}


TEST(makeHexCore, cellsBehindTheBodyAreLeftOut)
{
    const polyMeshParts parts
    (
        filled
        (
            boxTo(point::uniform(1)), [](const point&) { return scalar(0.1); }
        )
    );
    const partsMesh memory(parts);
    const scalar volume = sum(memory().cellVolumes());

    // Cells that the body touches are there
    EXPECT_GT
    (
        volume,
        8 - testSurfaces::enclosedVolume(testSurfaces::sphere(4, 0.3))
    );
    EXPECT_LT(volume, 8);
    EXPECT_GT(parts.topology.patchSizes[2], 0);
}


TEST(makeHexCore, facesOnSmallerPartsBehindTheBodyHaveTheirPoints)
{
    // Finer inside of the body, where parts of it are left out
    const polyMeshParts parts
    (
        filled
        (
            boxTo(point::uniform(1)),
            [](const point& x) { return mag(x) < 0.25 ? 0.05 : 0.2; }
        )
    );

    label nBehind = 0;
    forAll(parts.topology.faces, facei)
    {
        const face& f = parts.topology.faces[facei];
        EXPECT_GE(min(f), 0) << facei;
        nBehind += facei >= parts.topology.patchStarts[2];
    }
    EXPECT_GT(nBehind, 0);
}


TEST(makeHexCore, cellsAreNoWiderThanTheSizes)
{
    const auto size = [](const point& x) { return 0.1 + 0.2*mag(x); };
    const polyMeshParts parts(filled(boxTo(point::uniform(1)), size));
    const partsMesh memory(parts);

    forAll(memory().cellCentres(), celli)
    {
        EXPECT_LT
        (
            Foam::cbrt(memory().cellVolumes()[celli]),
            1.2001*size(memory().cellCentres()[celli])
        );
    }
}


TEST(makeHexCore, moreCellsThanAllowedAreRefused)
{
    expectWords
    (
        thrownMessage<error>
        (
            [&]()
            {
                filled
                (
                    boxTo(point::uniform(1)),
                    [](const point&) { return scalar(0.05); }, 1000
                );
            }
        ),
        {"maxCells 1000", "hexahedra"}
    );
}


// ************************************************************************* //
