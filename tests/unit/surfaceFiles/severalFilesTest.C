/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "splitAtSidePatches.H"
#include "openSurfaces.H"
#include "surfacePart.H"
#include "surfaceFiles.H"
#include "thrownMessage.H"
#include "wallDefects.H"

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The upper and the lower half of a cube in files of their own
class severalFiles
:
    public surfaceFiles
{
protected:

    fileNameList halves(const scalar gap, const word& extension)
    {
        wallSurface lower(halfCube(4));
        for (point& x : lower.points)
        {
            x.z() *= -1;
        }
        lower = reversed(lower);

        return fileNameList
        ({
            file("upper." + extension, halfCube(4)),
            file
            (
                "lower." + extension, translated(lower, vector(0, 0, -gap))
            )
        });
    }


    wallSurface readAll(const fileNameList& files)
    {
        return readWallSurface(files, controls_, reading_);
    }
};

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_F(severalFiles, thatFitAreOneClosedSurface)
{
    for (const word extension : {"obj", "stl"})
    {
        const wallSurface wall(readAll(halves(0, extension)));

        EXPECT_TRUE(testSurfaces::isClosed(wall));
        EXPECT_EQ(wall.points.size(), 98);
        EXPECT_NEAR(testSurfaces::enclosedVolume(wall), 1, 1e-12);
        EXPECT_EQ(wall.patchNames, wordList({"upper", "lower"}));
        EXPECT_TRUE(findWallDefects(wall).empty());
    }
}


TEST_F(severalFiles, solidsWithoutNamesAreOfTheirFiles)
{
    // Each file has a solid that an exporter has named, and one with a name
    for (const std::string name : {"ascii", "patch0", "zone1", "Solid_2"})
    {
        const std::string faces("g " + name + "\nf 1 2 3\ng lid\nf 1 3 4\n");
        fileNameList files(2);
        files[0] = file
        (
            "one.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + faces
        );
        files[1] = file
        (
            "two.obj", "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n" + faces
        );

        EXPECT_EQ
        (
            readAll(files).patchNames,
            wordList({"one_" + name, "lid", "two_" + name})
        );

        // One file alone keeps them
        files.setSize(1);
        EXPECT_EQ(readAll(files).patchNames, wordList({name, "lid"}));
    }
}


TEST_F(severalFiles, patchesGetNamesByFileAndSolid)
{
    surfacePatchName top, all;
    all.name = "hull";
    all.file = wordRe("upper.obj");
    top.name = "keel";
    top.solid = wordRe("low.*", wordRe::DETECT);
    controls_.patches = {all, top};
    EXPECT_EQ
    (
        readAll(halves(0, "obj")).patchNames, wordList({"hull", "keel"})
    );

    // The last entry that matches wins, and one name is one patch
    controls_.patches[0].file = wordRe(".*", wordRe::REGEX);
    controls_.patches[1].name = "hull";
    EXPECT_EQ(readAll(halves(0, "obj")).patchNames, wordList({"hull"}));

    controls_.patches[1].solid = wordRe("keel");
    expectWords
    (
        thrownMessage<Foam::error>([&]() { readAll(halves(0, "obj")); }),
        {"hull of surface.patches matches no solid", "upper.obj: "}
    );
}


TEST_F(severalFiles, equalPointsAreCounted)
{
    readAll(halves(0, "obj"));

    EXPECT_EQ(reading_.mergedPoints, 16);
    EXPECT_EQ(reading_.nearPoints, 0);
}


TEST_F(severalFiles, thatDoNotFitAreOpen)
{
    const wallSurface wall(readAll(halves(1e-7, "obj")));
    const List<wallDefect> defects(findWallDefects(wall));

    EXPECT_EQ(reading_.mergedPoints, 0);
    EXPECT_EQ(reading_.nearPoints, 16);
    EXPECT_EQ(outline(wall.faces).size(), 32);
    EXPECT_NE(describe(defects).find("32 open edges"), std::string::npos)
        << describe(defects);
}


TEST_F(severalFiles, aToleranceJoinsThem)
{
    controls_.mergeTolerance = 1e-6;
    const wallSurface wall(readAll(halves(1e-7, "obj")));

    EXPECT_EQ(reading_.mergedPoints, 16);
    EXPECT_TRUE(testSurfaces::isClosed(wall));
}


TEST_F(severalFiles, componentsAreTurnedWhenTheyAreJoined)
{
    fileNameList files(halves(0, "obj"));
    const wallSurface lower(read(files[1]));
    files[1] = file("turned.obj", reversed(lower));
    const wallSurface upper(reversed(read(files[0])));
    files[0] = file("upper.obj", upper);
    const wallSurface wall(readAll(files));

    EXPECT_EQ(reading_.flippedFaces, 96);
    EXPECT_NEAR(testSurfaces::enclosedVolume(wall), 1, 1e-12);
}


TEST_F(severalFiles, patchesOfOneNameAreOne)
{
    const wallSurface upper(halfCube(4));
    const fileNameList files
    ({
        file("wall.obj", upper),
        file("wall.stl", translated(upper, vector(3, 0, 0)))
    });

    EXPECT_EQ(readAll(files).patchNames, wordList({"wall"}));
}


TEST_F(severalFiles, aDuctAndItsInletAndOutlet)
{
    const wallSurface surface(duct(4));
    fileNameList files;
    for (label patchi = 0; patchi < 3; ++patchi)
    {
        wallSurface part(surface);
        part.faces.clear();
        forAll(surface.faces, facei)
        {
            if (surface.patchIDs[facei] == patchi)
            {
                part.faces.append(surface.faces[facei]);
            }
        }
        removeUnusedPoints(part.faces, part.points);
        files.append(file(surface.patchNames[patchi] + ".obj", part));
    }
    controls_.fluidOutside = false;
    const wallSurface all(readAll(files));
    const wallSurface wall(endedOn(all, wordList({"inlet", "outlet"})));

    EXPECT_EQ(reading_.mergedPoints, 32);
    EXPECT_NEAR(testSurfaces::enclosedVolume(all), -1, 1e-12);
    EXPECT_EQ(wall.faces.size(), 64);
    EXPECT_EQ(wall.border.edges.size(), 32);
    EXPECT_EQ(wall.border.sides.size(), 2);
}


// ************************************************************************* //
