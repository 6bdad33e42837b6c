/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boundBox.H"
#include "ListOps.H"
#include "openSurfaces.H"
#include "wallDefects.H"
#include "cellPredicates.H"
#include "spaceParts.H"
#include "spaceRegions.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A cube from 'low' on, with edges of a size
static wallSurface cubeAt
(
    const point& low,
    const scalar size,
    const label n = 1
)
{
    const wallSurface at(cube(n, size));

    return translated(at, low - boundBox(at.points, false).min());
}


//- Faces between two regions
static label nBetween(const spaceRegions& all, const label a, const label b)
{
    label n = 0;
    for (const labelPair& both : all.regionsOfFace)
    {
        n += both == labelPair(a, b) || both == labelPair(b, a);
    }

    return n;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(makeSpaceRegions, solidsThatTouchOthersAndTheBoxHaveAllFacesInCommon)
{
    // Two cubes side by side on the floor of a box. Their triangles differ.
    const wallSurface solids
    (
        merge
        (
            cubeAt(point(1, 1, 0), 1, 3),
            cubeAt(point(2, 1.25, 0), 1, 2)
        )
    );
    const wallSurface all(merge(cubeAt(point(0, 0, 0), 4), solids));
    const List<regionSeed> seeds
    ({
        {"air", point(0.3, 0.2, 3.1)},
        {"left", point(1.5, 1.5, 0.5)},
        {"right", point(2.5, 1.75, 0.5)}
    });
    const spaceRegions made(makeSpaceRegions(makeArrangement(all), seeds));

    EXPECT_NEAR(made.regions[0].volume, 62, 1e-10);
    EXPECT_NEAR(made.regions[1].volume, 1, 1e-12);
    EXPECT_NEAR(made.regions[2].volume, 1, 1e-12);
    EXPECT_GT(nBetween(made, 0, 1), 0);
    EXPECT_GT(nBetween(made, 0, 2), 0);
    EXPECT_GT(nBetween(made, 1, 2), 0);
    forAll(made.regions, i)
    {
        const spaceRegion& region = made.regions[i];
        EXPECT_TRUE(isClosed(region.surface));
        EXPECT_NEAR
        (
            testSurfaces::enclosedVolume(region.surface), -region.volume, 1e-10
        );
        forAll(region.points, p)
        {
            EXPECT_EQ
            (
                region.surface.points[p], made.surface.points[region.points[p]]
            );
        }
    }

    // The floor has no region below it
    labelList numbers(4, Zero);
    forAll(made.regions[1].faces, f)
    {
        ++numbers[1 + made.beyond(1, f)];
    }
    EXPECT_GT(numbers[0], 0);
    EXPECT_EQ(numbers[2], 0);
    EXPECT_EQ(numbers[3], nBetween(made, 1, 2));
}


TEST(makeSpaceRegions, bodiesWithinOthersAreHolesOfTheirs)
{
    const wallSurface all
    (
        merge
        (
            cubeAt(point(0, 0, 0), 9),
            merge
            (
                merge(cubeAt(point(1, 1, 1), 3), cubeAt(point(2, 2, 2), 1)),
                cubeAt(point(5, 5, 5), 2)
            )
        )
    );
    const List<regionSeed> seeds
    ({
        {"outer", point(0.1, 0.2, 0.3)},
        {"shell", point(1.2, 1.3, 1.4)}
    });
    const spaceRegions made(makeSpaceRegions(makeArrangement(all), seeds));

    EXPECT_NEAR(made.regions[0].volume, 729 - 27 - 8, 1e-9);
    EXPECT_NEAR(made.regions[1].volume, 27 - 1, 1e-10);
}


TEST(makeSpaceRegions, manyBodiesSideBySideAreHolesOfOneRegion)
{
    wallSurface all(cubeAt(point(0, 0, 0), 10));
    for (label i = 0; i < 27; ++i)
    {
        const point low(1 + 3*(i % 3), 1 + 3*(i/3 % 3), 1 + 3*(i/9));
        all = merge(all, cubeAt(low, 2));
    }
    const spaceRegions made
    (
        makeSpaceRegions
        (
            makeArrangement(all),
            List<regionSeed>({{"air", point(0.1, 0.2, 0.3)}})
        )
    );

    EXPECT_NEAR(made.regions[0].volume, 1000 - 27*8, 1e-9);
}


TEST(makeArrangement, aFoldIsGone)
{
    // The middle of an edge is moved along its face, over the other edge
    wallSurface folded(cubeAt(point(0, 0, 0), 1, 1));
    const label nFaces = folded.faces.size();
    face& f = folded.faces[0];
    const point a(folded.points[f[0]]);
    const point b(folded.points[f[1]]);
    const point c(folded.points[f[2]]);

    // Two more triangles on edge ab that lie on each other
    folded.points.append(0.4*a + 0.4*b + 0.2*c);
    const label p = folded.points.size() - 1;
    const face other({f[0], f[1], p});
    folded.faces[0] = face({f[0], f[1], f[2]});
    folded.faces.append(other);
    folded.faces.append(other.reverseFace());
    folded.patchIDs = labelList(folded.faces.size(), Zero);

    const wallSurface made(makeArrangement(folded));
    EXPECT_TRUE(isClosed(made));
    EXPECT_NEAR(mag(testSurfaces::enclosedVolume(made)), 1, 1e-12);
    EXPECT_GE(made.faces.size(), nFaces);
}


TEST(makeSpaceRegions, bodiesThatCutEachOtherAreDivided)
{
    const wallSurface all
    (
        merge(cubeAt(point(0, 0, 0), 2), cubeAt(point(1, 1, 1), 2))
    );
    const List<regionSeed> seeds
    ({
        {"first", point(0.1, 0.2, 0.3)},
        {"both", point(1.2, 1.3, 1.4)},
        {"second", point(2.9, 2.8, 2.7)}
    });
    const spaceRegions made(makeSpaceRegions(makeArrangement(all), seeds));

    EXPECT_NEAR(made.regions[0].volume, 7, 1e-12);
    EXPECT_NEAR(made.regions[1].volume, 1, 1e-12);
    EXPECT_NEAR(made.regions[2].volume, 7, 1e-12);
    EXPECT_EQ(nBetween(made, 0, 2), 0);
}


TEST(makeSpaceRegions, anOpeningIsNamedWithItsPlaceAndAPathThroughIt)
{
    wallSurface all
    (
        merge(cubeAt(point(0, 0, 0), 4), cubeAt(point(1, 1, 1), 2, 4))
    );

    // Two triangles of the inner cube's top, around (2.25, 2.25, 3)
    boolList isKept(all.faces.size(), true);
    forAll(all.faces, i)
    {
        const point c(all.faces[i].centre(all.points));
        isKept[i] = mag(c - point(2.25, 2.25, 3)) > 0.2;
    }
    all.patchIDs = subset(isKept, all.patchIDs);
    all.faces = subset(isKept, all.faces);

    const std::string message(thrownMessage<Foam::error>([&]()
    {
        makeSpaceRegions
        (
            makeArrangement(all),
            List<regionSeed>
            ({
                {"air", point(0.1, 0.2, 0.3)}, {"water", point(1.2, 1.3, 1.4)}
            })
        );
    }));
    EXPECT_NE(message.find("water leaks into the region air"), string::npos)
        << message;
    EXPECT_NE(message.find("2.3"), string::npos) << message;
}


TEST(makeSpaceRegions, aPointOutsideOfAllLeaks)
{
    const std::string message(thrownMessage<Foam::error>([&]()
    {
        makeSpaceRegions
        (
            makeArrangement(cubeAt(point(0, 0, 0), 1)),
            List<regionSeed>({{"air", point(2, 2, 2)}})
        );
    }));
    EXPECT_NE(message.find("air leaks into the outside"), string::npos)
        << message;
}


//- A square of a size about the centre of a box of size 3, in n^2 squares of
//  two triangles
static wallSurface sheetInBox(const label n)
{
    wallSurface sheet(testSurfaces::sheet(n, 0));
    for (point& x : sheet.points)
    {
        x += vector(1, 1, 1.5);
    }
    sheet.patchNames = wordList({"sheet"});
    wallSurface box(cubeAt(point(0, 0, 0), 3));
    box.patchNames = wordList({"box"});

    return makeArrangement(merge(box, sheet));
}


static const List<regionSeed> inAir({{"air", point(0.1, 0.2, 0.3)}});

static const wordRes sheetIsBaffle(List<wordRe>({wordRe("sheet")}));


static void open(spaceRegions& all)
{
    all.open
    (
        0, [](const word& patch) { return patch == "box"; }, layerOpening
    );
}


TEST(makeSpaceRegions, aSheetIsRefusedWithItsPlaceUnlessItIsABaffle)
{
    const wallSurface surface(sheetInBox(2));
    const std::string message(thrownMessage<Foam::error>([&]()
    {
        makeSpaceRegions(surface, inAir);
    }));
    EXPECT_NE(message.find("within the region air"), string::npos) << message;
    EXPECT_NE(message.find("surface.baffles"), string::npos) << message;

    const spaceRegions made(makeSpaceRegions(surface, inAir, sheetIsBaffle));
    EXPECT_NEAR(made.regions[0].volume, 27, 1e-12);
    forAll(made.regions[0].faces, f)
    {
        EXPECT_EQ(made.beyond(0, f), -1);
    }
}


TEST(makeSpaceRegions, sidesOfASheetHavePointsOfTheirOwnButAtFreeEdges)
{
    const label n = 4;
    const spaceRegions made
    (
        makeSpaceRegions(sheetInBox(n), inAir, sheetIsBaffle)
    );
    const spaceRegion& air = made.regions[0];
    EXPECT_TRUE(isClosed(air.surface));

    labelList nCopies(made.surface.points.size(), Zero);
    for (const label p : air.points)
    {
        ++nCopies[p];
    }
    label nTwice = 0;
    forAll(nCopies, p)
    {
        const point& x = made.surface.points[p];
        const bool isWithin =
            x.x() > 1 && x.x() < 2 && x.y() > 1 && x.y() < 2 && x.z() == 1.5;
        EXPECT_EQ(nCopies[p], isWithin ? 2 : 1) << x.x() << ' ' << x.y();
        nTwice += isWithin;
    }
    EXPECT_GE(nTwice, (n - 1)*(n - 1));
}


TEST(makeSpaceRegions, edgesOfASheetBetweenItsFreeEdgesAreDivided)
{
    // Two triangles: all points are on free edges
    const spaceRegions made
    (
        makeSpaceRegions(sheetInBox(1), inAir, sheetIsBaffle)
    );
    EXPECT_TRUE(isClosed(made.regions[0].surface));
    label nTriangles = 0;
    forAll(made.surface.faces, f)
    {
        nTriangles += made.isSheet(f);
    }
    EXPECT_EQ(nTriangles, 4);
}


TEST(spaceRegions, whatIsBesideNoRegionIsCounted)
{
    // A solid without a region has a shell inside of it
    const auto named = [](wallSurface surface, const word& patch)
    {
        surface.patchNames = wordList(1, patch);
        surface.patchIDs = labelList(surface.faces.size(), Zero);
        return surface;
    };
    const wallSurface all
    (
        merge
        (
            named(cubeAt(point(0, 0, 0), 4), "room"),
            merge
            (
                named(cubeAt(point(1, 1, 1), 2), "solid"),
                named(cubeAt(point(1.5, 1.5, 1.5), 1), "shell")
            )
        )
    );
    const List<regionSeed> seeds({{"air", point(0.3, 0.2, 3.1)}});
    const spaceRegions made(makeSpaceRegions(makeArrangement(all), seeds));
    const List<unusedArea> areas(unusedAreas(made));
    for (const label patchi : {0, 1, 2})
    {
        const unusedArea& area = areas[patchi];
        const bool isShell = made.surface.patchNames[patchi] == "shell";
        EXPECT_NEAR(area.unused, isShell ? 6 : 0, 1e-12) << patchi;
        EXPECT_GE(area.whole, 6) << patchi;
    }
}


TEST(spaceRegions, anOpenedSheetIsAnOrdinaryWallAndComesBack)
{
    spaceRegions all(makeSpaceRegions(sheetInBox(4), inAir, sheetIsBaffle));
    const pointField before(all.regions[0].surface.points);
    EXPECT_FALSE(findWallDefects(all.regions[0].surface).empty());

    open(all);
    const spaceRegion& air = all.regions[0];
    EXPECT_TRUE(findWallDefects(air.surface).empty());
    const scalar moved = max(mag(air.surface.points - before));
    EXPECT_GT(moved, 0);
    EXPECT_LT(moved, 1e-9);

    // Into the region: the sheet becomes a hole
    EXPECT_LT(-testSurfaces::enclosedVolume(air.surface), 27);

    pointField mesh(air.surface.points);
    mesh.append(point(0.5, 0.5, 0.5));
    EXPECT_GT(all.close(0, mesh).count(), 0u);
    EXPECT_EQ(pointField(mesh, identity(before.size())), before);
    EXPECT_EQ(air.surface.points, before);
    EXPECT_EQ(mesh.last(), point(0.5, 0.5, 0.5));
}


TEST(spaceRegions, bodiesMayTouchInAnEdgeAndNotInAPoint)
{
    const auto bodies = [&](const scalar z)
    {
        wallSurface box(cubeAt(point(0, 0, 0), 3));
        box.patchNames = wordList({"box"});
        const wallSurface both
        (
            merge
            (
                cubeAt(point(0.5, 0.5, 1), 1), cubeAt(point(1.5, 1.5, z), 1)
            )
        );

        return makeSpaceRegions(makeArrangement(merge(box, both)), inAir);
    };
    spaceRegions inEdge(bodies(1));
    open(inEdge);
    EXPECT_TRUE(isClosed(inEdge.regions[0].surface));

    spaceRegions inPoint(bodies(2));
    const std::string message(thrownMessage<Foam::error>([&]()
    {
        open(inPoint);
    }));
    EXPECT_NE(message.find("in a point alone, at (1.5 1.5 2)"), string::npos)
        << message;
}


// ************************************************************************* //
