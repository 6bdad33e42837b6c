/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "minimalControls.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static std::string farField(const std::string& entries)
{
    return surface + layers + "farField { type tet; " + entries + " }";
}


static std::string boundary(const std::string& entries)
{
    return farField("boundary { " + entries + " }");
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(readFarFieldControls, readsABoxWithPatches)
{
    const farFieldControls controls
    (
        readControls
        (
            farField
            (
                "boundary { type box; min (-1 -2 -3); max (1 2 3);"
                " patches { inlet { sides (xMin); }"
                " ground { type wall; sides (\"z.*\"); } } }"
                " growthRate 1.3; maxCellSize 0.5; maxCells 1000;"
            )
        ).farField
    );

    EXPECT_EQ(controls.type, farFieldType::tet);
    EXPECT_EQ(controls.boundary.type, farBoundaryType::box);
    EXPECT_EQ(controls.boundary.box.max(), point(1, 2, 3));
    EXPECT_EQ(controls.boundary.patches.size(), 2);
    EXPECT_EQ(controls.boundary.patches[0].name, "inlet");
    EXPECT_EQ(controls.boundary.patches[0].type, "patch");
    EXPECT_TRUE(controls.boundary.patches[0].sides.match("xMin"));
    EXPECT_EQ(controls.boundary.patches[1].type, "wall");
    EXPECT_TRUE(controls.boundary.patches[1].sides.match("zMax"));
    EXPECT_EQ(controls.growthRate, 1.3);
    EXPECT_EQ(controls.maxCellSize, 0.5);
    EXPECT_EQ(controls.maxCells, 1000);
}


TEST(readFarFieldControls, readsASphereASurfaceAndRegions)
{
    const farFieldControls sphere
    (
        readControls
        (
            farField
            (
                "boundary { type sphere; origin (1 0 0); radius 7; }"
                " regions { wake { geometry { type searchableSphere; }"
                " mode distance; distance 2; cellSize 0.1; } }"
            )
        ).farField
    );
    EXPECT_EQ(sphere.boundary.origin, point(1, 0, 0));
    EXPECT_EQ(sphere.boundary.radius, 7);
    EXPECT_EQ(sphere.regions.size(), 1);
    EXPECT_EQ(sphere.regions[0].cellSize, 0.1);
    EXPECT_EQ(sphere.regions[0].distance, 2);

    // The patch of a region has its name where no sides are given
    const farFieldControls file
    (
        readControls
        (
            boundary
            (
                "type surface; file \"far.obj\"; scale 0.001;"
                " patches { ground { type wall; } }"
            )
        ).farField
    );
    EXPECT_EQ(file.boundary.file, "far.obj");
    EXPECT_EQ(file.boundary.scale, 0.001);
    EXPECT_TRUE(file.boundary.patches[0].sides.match("ground"));
}


TEST(readFarFieldControls, theFluidDecidesOnABoundary)
{
    expectWords(errorOf(farField("")), {"has no boundary"});
    expectWords
    (
        errorOf
        (
            "surface { file \"a.obj\"; fluid inside; }" + layers
          + "farField { type tet;"
            " boundary { type sphere; origin (0 0 0); radius 1; } }"
        ),
        {"inside", "no far boundary"}
    );
    EXPECT_EQ
    (
        readControls
        (
            "surface { file \"a.obj\"; fluid inside; }" + layers
          + "farField { type tet; }"
        ).farField.boundary.type,
        farBoundaryType::none
    );
}


TEST(readFarFieldControls, wrongEntriesAreRefused)
{
    expectWords(errorOf(boundary("type cone;")), {"cone", "box, sphere"});
    expectWords(errorOf(boundary("min (0 0 0);")), {"type", "missing"});
    expectWords
    (
        errorOf(boundary("type box; min (0 0 0); max (1 0 1);")),
        {"max", "(1 0 1)", "(0 0 0)"}
    );
    expectWords
    (
        errorOf(boundary("type sphere; origin (0 0 0);")),
        {"radius", "missing"}
    );
    expectWords
    (
        errorOf(boundary("type sphere; origin (0 0 0); radius -1;")),
        {"radius is -1"}
    );
    expectWords
    (
        errorOf
        (
            boundary("type box; min (0 0 0); max (1 1 1); radius 2;")
        ),
        {"radius", "not one of", "type box"}
    );
    expectWords
    (
        errorOf
        (
            boundary
            (
                "type box; min (0 0 0); max (1 1 1);"
                " patches { inlet { type mappedPatch; } }"
            )
        ),
        {"mappedPatch", "patch, wall, symmetry"}
    );
    expectWords(errorOf(farField("growthRate 1;")), {"growthRate is 1"});
    expectWords(errorOf(farField("maxCells 0;")), {"maxCells is 0"});
    expectWords
    (
        errorOf(farField("regions { wake { geometry {} } }")),
        {"cellSize", "missing"}
    );
    expectWords(errorOf(boundary("typ box;")), {"typ", "did you mean type"});
}


// ************************************************************************* //
