/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farBoundary.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static farBoundary boxWith(const List<farPatch>& patches)
{
    farBoundaryControls controls;
    controls.type = farBoundaryType::box;
    controls.box = boundBox(point(0, 0, 0), point(1, 2, 3));
    controls.patches = patches;

    return makeFarBoundary
    (
        controls, [](const fileName& file) { return file; }
    );
}


static farBoundary boxWith(const farPatch& patch)
{
    return boxWith(List<farPatch>(1, patch));
}


static farPatch patchOf(const word& name, const wordRe& sides)
{
    farPatch patch;
    patch.name = name;
    patch.sides = wordRes(1, sides);

    return patch;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(farBoundary, sidesOfABoxAreWhereTheirNamesSay)
{
    const wallSurface box(boxWith(patchOf("xMin", wordRe("xMin"))).surface);

    forAll(box.faces, facei)
    {
        const word& side = box.patchNames[box.patchIDs[facei]];
        const direction d = side[0] - 'x';
        const point centre(box.faces[facei].centre(box.points));
        const vector normal(box.faces[facei].unitNormal(box.points));
        const bool high = side.substr(1) == "Max";

        EXPECT_EQ(centre[d], high ? d + 1 : 0) << side;
        EXPECT_EQ(normal[d], high ? -1 : 1) << side;
        EXPECT_NEAR(box.faces[facei].mag(box.points), 3.0/(d + 1), 1e-12);
    }
}


TEST(farBoundary, patchesTakeTheirSides)
{
    farPatch sides(patchOf("sides", wordRe("[yz].*", wordRe::REGEX)));
    sides.type = "symmetry";
    const farBoundary boundary(boxWith(sides));

    EXPECT_EQ(boundary.surface.patchNames, wordList({"sides", "xMin", "xMax"}));
    EXPECT_EQ(boundary.patchTypes, wordList({"symmetry", "patch", "patch"}));

    // Two triangles on each side
    labelList nFaces(3, Zero);
    for (const label patchi : boundary.surface.patchIDs)
    {
        ++nFaces[patchi];
    }
    EXPECT_EQ(nFaces, labelList({8, 2, 2}));
    EXPECT_EQ(testSurfaces::enclosedVolume(boundary.surface), -6);
    EXPECT_TRUE(testSurfaces::isClosed(boundary.surface));
}


TEST(farBoundary, sidesThatAreNotThereAreRefused)
{
    expectWords
    (
        thrownMessage<error>
        (
            []() { boxWith(patchOf("inlet", wordRe("west"))); }
        ),
        {"patch inlet", "west", "xMin"}
    );

    // Part of another patch, its own name is taken
    expectWords
    (
        thrownMessage<error>
        (
            []() { boxWith(patchOf("xMin", wordRe("xMax"))); }
        ),
        {"side xMin", "not in the patch of the same name"}
    );
}


TEST(farBoundary, patchesWhoseSidesLaterOnesTakeAreRefused)
{
    const farPatch inlet(patchOf("inlet", wordRe("xMin")));
    const farPatch sides(patchOf("sides", wordRe(".*", wordRe::REGEX)));

    expectWords
    (
        thrownMessage<error>([&]() { boxWith({inlet, sides}); }),
        {"patch inlet", "xMin", "later patches"}
    );
    EXPECT_EQ
    (
        boxWith({sides, inlet}).surface.patchNames,
        wordList({"sides", "inlet"})
    );
}


//- What checkBodies says to a small cube that is moved beside a larger one with
//  the fluid inside, whose last triangles are of the far boundary
static std::string errorBeside(const vector& by, const label nFar)
{
    wallSurface both
    (
        testSurfaces::merge
        (
            testSurfaces::translated(testSurfaces::cube(1, 0.5), by),
            testSurfaces::reversed(testSurfaces::cube(2, 2))
        )
    );
    both.patchIDs.clear();

    return thrownMessage<error>
    (
        [&]() { checkBodies(both, both.faces.size() - nFar); }
    );
}


TEST(checkBodies, bodiesOutsideOfTheFluidAreRefused)
{
    for (const label nFar : {0, 8})
    {
        EXPECT_EQ(errorBeside(vector(0.5, 0.5, 0.5), nFar), "");
        expectWords
        (
            errorBeside(vector(3, 0.5, 0.5), nFar),
            {"the body at (3", "outside of the fluid", "is 1 m from it"}
        );
    }
}


TEST(checkBodies, bodiesBesideEachOtherAreNot)
{
    const wallSurface both
    (
        testSurfaces::merge
        (
            testSurfaces::cube(1, 1),
            testSurfaces::translated(testSurfaces::cube(1, 1), vector(2, 0, 0))
        )
    );
    EXPECT_NO_THROW(checkBodies(both, both.faces.size()));
}


TEST(checkBodies, cavitiesOfOtherBodiesAreNotAroundTheFluid)
{
    const wallSurface hollow
    (
        testSurfaces::merge
        (
            testSurfaces::cube(1, 1),
            testSurfaces::translated
            (
                testSurfaces::reversed(testSurfaces::cube(1, 0.5)),
                vector(0.25, 0.25, 0.25)
            )
        )
    );
    const wallSurface both
    (
        testSurfaces::merge
        (
            hollow,
            testSurfaces::translated(testSurfaces::cube(1, 1), vector(2, 0, 0))
        )
    );
    EXPECT_NO_THROW(checkBodies(both, both.faces.size()));
}


// ************************************************************************* //
