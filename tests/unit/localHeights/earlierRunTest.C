/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "earlierRun.H"
#include "prismPolyMesh.H"
#include "temporaryFiles.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "thrownMessage.H"
#include "Time.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A case with layers of heights 0.1 and 0.2 on a cube, whose patches are low
//  and high
class earlierRun
:
    public temporaryFiles
{
protected:

    wallSurface wall_ = testSurfaces::quadCube(2);
    yPlusRun run_;

    void SetUp() override
    {
        temporaryFiles::SetUp();
        wall_.patchNames = wordList({"low", "high"});
        forAll(wall_.faces, facei)
        {
            wall_.patchIDs[facei] =
                wall_.faces[facei].centre(wall_.points).z() < 0.5 ? 0 : 1;
        }
        run_.target = 1;
        run_.folder = folder_;
    }

    void writeMesh() const
    {
        infoDetailLevel = 0;
        Time time
        (
            dictionaryOf("deltaT 1; writeInterval 1;"),
            folder_.path(), folder_.name(), "system", "constant", false, false
        );
        farFieldMesh none;
        const prismLayers layers
        (
            testSurfaces::straightLayers(wall_, scalarList({0, 0.1, 0.3}))
        );
        const unsigned int digits = IOstream::defaultPrecision(17);
        makePrismPolyMesh
        (
            layers, none,
            IOobject
            (
                polyMesh::defaultRegion, time.constant(), time,
                IOobject::NO_READ, IOobject::AUTO_WRITE
            )
        )->write();
        IOstream::defaultPrecision(digits);
    }

    //- The field at a time, with entries of the patches
    void writeField(const std::string& time, const std::string& patches) const
    {
        mkDir(folder_/time);
        file
        (
            time + "/yPlus",
            "FoamFile { version 2.0; format ascii; class volScalarField;"
            " object yPlus; } dimensions [0 0 0 0 0 0 0];"
            " internalField uniform 0; boundaryField { " + patches + " }"
        );
    }

    static std::string entry(const std::string& name, const std::string& value)
    {
        return name + " { type calculated; value " + value + "; } ";
    }

    wallsOfRun read(const wordList& names = wordList({"low", "high"})) const
    {
        return readWallsOfRun(run_, folder_, names);
    }

    std::string errorOf(const wordList& names = wordList({"low", "high"})) const
    {
        return thrownMessage<error>([&]() { read(names); });
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_F(earlierRun, hasYPlusAndHeightsOfFaces)
{
    writeMesh();
    writeField
    (
        "5", entry("low", "uniform 2") + entry("high", "uniform 3")
      + entry("layerOuter", "uniform 0")
    );
    const wallsOfRun walls(read());

    EXPECT_EQ(walls.time, "5");
    EXPECT_EQ(walls.surface.patchNames, wordList({"low", "high"}));
    EXPECT_EQ(walls.surface.points.size(), wall_.points.size());
    ASSERT_EQ(walls.surface.faces.size(), wall_.faces.size());
    EXPECT_NEAR(testSurfaces::enclosedVolume(walls.surface), 1, 1e-12);

    // Columns on the sides of a cube become wider: the area of a quarter at a
    // height h is (1/2 + h)^2, and the height is that of the frustum, 2V/(A0 +
    // A1)
    const auto area = [](const scalar h) { return sqr(0.5 + h); };
    const auto height = [&](const scalar low, const scalar high)
    {
        const scalar volume =
            (pow3(0.5 + high) - pow3(0.5 + low))/3;

        return 2*volume/(area(low) + area(high));
    };

    forAll(walls.yPlus, facei)
    {
        EXPECT_EQ(walls.yPlus[facei], walls.surface.patchIDs[facei] + 2);
        EXPECT_NEAR(walls.firstHeight[facei], height(0, 0.1), 1e-12);
        EXPECT_NEAR
        (
            walls.thickness[facei], height(0, 0.1) + height(0.1, 0.3), 1e-12
        );
    }
}


TEST_F(earlierRun, latestTimeIsTheLastOneWithTheField)
{
    writeMesh();
    writeField("1", entry("\".*\"", "uniform 1"));
    writeField("2.5", entry("\".*\"", "uniform 2"));
    mkDir(folder_/"10");

    EXPECT_EQ(read().time, "2.5");
    run_.isLatest = false;
    run_.time = 1;
    EXPECT_EQ(read().yPlus[0], 1);
    run_.time = 3;
    expectWords(errorOf(), {folder_.c_str(), "yPlus.from", "no time 3"});
}


TEST_F(earlierRun, patchesAreChosenByName)
{
    writeMesh();
    writeField("1", entry("\".*\"", "uniform 1"));

    EXPECT_EQ(read(wordList({"high", "new"})).surface.patchNames.size(), 1);
    expectWords
    (
        errorOf(wordList({"new", "layerOuter"})),
        {"yPlus.from", "none of the walls new", "low, high"}
    );
}


TEST_F(earlierRun, whatIsMissingIsNamed)
{
    expectWords(errorOf(), {folder_.c_str(), "no time with the field yPlus"});
    mkDir(folder_/"processor0");
    expectWords(errorOf(), {"decomposed", "reconstructPar"});

    writeField("1", entry("low", "uniform 1"));
    expectWords(errorOf(), {"no mesh", "polyMesh", "decomposed"});

    writeMesh();
    expectWords(errorOf(), {"patch high", "1/yPlus", "12 faces"});

    expectWords
    (
        thrownMessage<error>([&]()
        {
            readWallsOfRun(run_, folder_/"none", wordList({"low"}));
        }),
        {"none", "yPlus.from", "no such folder"}
    );
}


TEST_F(earlierRun, valuesThatAreNoYPlusAreRefused)
{
    writeMesh();
    writeField("1", entry("low", "uniform 1") + entry("high", "uniform 0"));
    expectWords
    (
        errorOf(), {"patch high", "1/yPlus", "zero everywhere", "solver"}
    );
    writeField("1", entry("low", "uniform -1") + entry("high", "uniform 1"));
    expectWords(errorOf(), {"patch low", "1/yPlus", "is -1 at ("});
    writeField
    (
        "1", entry("low", "nonuniform List<scalar> 2(1 1)")
      + entry("high", "uniform 1")
    );
    expectWords
    (
        errorOf(), {"patch low", "1/yPlus", "12 faces", "size 2"}
    );
}


// ************************************************************************* //
