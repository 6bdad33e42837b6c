/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadSurface.H"
#include "isolatedProcess.H"
#include "surfaceFiles.H"
#include "thrownMessage.H"
#include "wallDefects.H"

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A value of a variable of the environment that goes with this
class environmentVariable
{
    const std::string name_;
    const std::string before_;

public:

    environmentVariable(const std::string& name, const std::string& value)
    :
        name_(name),
        before_(std::getenv(name.c_str()) ? std::getenv(name.c_str()) : "")
    {
        ::setenv(name_.c_str(), value.c_str(), 1);
    }

    ~environmentVariable() { ::setenv(name_.c_str(), before_.c_str(), 1); }
};


//- Programs in place of gmsh, and the program itself
class cadSurfaceTest
:
    public surfaceFiles
{
protected:

    surfaceCadControls cad_;
    string remark_;

    //- A script that is called gmsh, first in PATH, and no other programs there
    //  but those of the shell
    std::string pathWith(const std::string& script) const
    {
        mkDir(folder_/"bin");
        file("bin/gmsh", "#!/bin/sh\n" + script);
        chMod(folder_/"bin"/"gmsh", 0755);

        return folder_/"bin:/usr/bin:/bin";
    }

    //- What gmsh writes of a tetrahedron, without the last faces
    static std::string tetrahedron(const int nFaces = 4)
    {
        std::string mesh("$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
        mesh += "$EndNodes\n$Elements\n" + std::to_string(nFaces) + "\n";
        const char* points[] = {"1 3 2", "1 2 4", "2 3 4", "1 4 3"};
        std::string model("solid\n");

        for (int i = 1; i <= 4; ++i)
        {
            const std::string n(std::to_string(i));
            model += "bound " + n + "\nface " + n + "\nlabel\n";
            if (i <= nFaces)
            {
                mesh += n + " 2 2 0 " + n + ' ' + points[i - 1] + '\n';
            }
        }

        return "cat > model << 'END'\n" + model + "END\n"
            "cat > body.msh << 'END'\n" + mesh + "END\n"
            "echo \"Info : 'gmsh' [Gmsh 9.9, 1 node]\"\n";
    }

    wallSurface readCad(const fileName& name)
    {
        return readCadSurface(name, cad_, false, 1, remark_);
    }

    //- The message of the error; the temporary folder is gone
    std::string errorOfCad(const fileName& name)
    {
        mkDir(folder_/"tmp");
        const environmentVariable folder("TMPDIR", folder_/"tmp");
        const std::string message
        (
            thrownMessage<Foam::error>([&]() { readCad(name); })
        );
        EXPECT_TRUE(readDir(folder_/"tmp", fileName::DIRECTORY).empty());

        return message;
    }

    //- A box of 10 x 20 x 30 mm as a STEP file, by gmsh
    fileName box(const std::string& name = "box.step")
    {
        file
        (
            "box.geo",
            "SetFactory(\"OpenCASCADE\"); Box(1) = {0, 0, 0, 10, 20, 30};"
        );
        EXPECT_EQ
        (
            runProgram
            (
                {"gmsh", "-0", "-o", "box.step", "box.geo"}, {}, folder_,
                "log", 60
            ),
            programEnd::complete
        )   << "Install the program gmsh: etc/setup -test";
        mv(folder_/"box.step", folder_/name);

        return folder_/name;
    }
};

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_F(cadSurfaceTest, filesAreKnownByTheirExtensions)
{
    EXPECT_EQ(cadType("a/b.step"), "step");
    EXPECT_EQ(cadType("b.STP"), "step");
    EXPECT_EQ(cadType("b.Brep"), "brep");
    EXPECT_EQ(cadType("b.igs"), "iges");
    EXPECT_EQ(cadType("b.IGES"), "iges");
    EXPECT_EQ(cadType("b.stl"), "");
    EXPECT_EQ(cadType("step"), "");
}


TEST_F(cadSurfaceTest, aMissingProgramIsNamed)
{
    const environmentVariable path("PATH", folder_);
    const fileName name(file("body.step", "ISO-10303-21;"));

    expectWords
    (
        errorOfCad(name), {name.c_str(), "Install", "gmsh", "triangles"}
    );
}


TEST_F(cadSurfaceTest, aMissingFileIsNamed)
{
    expectWords(errorOfCad(folder_/"none.step"), {"none.step", "no such file"});
}


TEST_F(cadSurfaceTest, theTimeLimitEndsTheProgram)
{
    const environmentVariable path("PATH", pathWith("sleep 30"));
    cad_.maxSeconds = 1;

    expectWords
    (
        errorOfCad(file("body.step", "")), {"longer than 1 s", "maxSeconds"}
    );
}


TEST_F(cadSurfaceTest, errorsOfTheProgramAreQuoted)
{
    const environmentVariable path
    (
        "PATH", pathWith("echo 'Error   : no such thing'; exit 1")
    );

    expectWords
    (
        errorOfCad(file("body.step", "")), {"finds no faces", "no such thing"}
    );
}


TEST_F(cadSurfaceTest, thePathOfTheFileIsNotForAShell)
{
    const environmentVariable path("PATH", pathWith(tetrahedron()));
    const std::string name("a;$(touch${IFS}x)`touch${IFS}x`.STEP");

    EXPECT_EQ(readCad(file(name, "")).faces.size(), 4);
    EXPECT_FALSE(has("x"));
}


TEST_F(cadSurfaceTest, anotherAlgorithmFollowsAFailure)
{
    const environmentVariable path
    (
        "PATH",
        pathWith
        (
            "if grep -q 'Algorithm = 6' body.geo; then\n" + tetrahedron(3)
          + "exit 1\nfi\n" + tetrahedron()
        )
    );

    EXPECT_EQ(readCad(file("body.brep", "")).faces.size(), 4);
    EXPECT_NE(remark_.find("gmsh 9.9, algorithm 1"), std::string::npos)
        << remark_;
}


TEST_F(cadSurfaceTest, theBestAlgorithmIsTaken)
{
    const environmentVariable path
    (
        "PATH",
        pathWith
        (
            tetrahedron(2) + "if grep -q 'Algorithm = 5' body.geo; then\n"
          + tetrahedron(3) + "fi\n"
        )
    );

    EXPECT_EQ(readCad(file("body.brep", "")).faces.size(), 3);
    EXPECT_NE(remark_.find("without triangles 1"), std::string::npos)
        << remark_;
    EXPECT_NE(remark_.find("open edges of solids 3"), std::string::npos)
        << remark_;
}


TEST_F(cadSurfaceTest, solidsThatCannotBeUnitedStayApart)
{
    const environmentVariable path
    (
        "PATH",
        pathWith
        (
            "if grep -q Coherence body.geo; then exit 1; fi\n" + tetrahedron()
        )
    );
    const fileName name(file("body.brep", ""));

    EXPECT_EQ(readCadSurface(name, cad_, true, 1, remark_).faces.size(), 4);
    EXPECT_EQ(remark_.find("united"), std::string::npos) << remark_;
}


TEST_F(cadSurfaceTest, aBrokenFileIsRefused)
{
    const std::string text("ISO-10303-21;\nHEADER;\nnothing\n");
    const fileName name(file("broken.step", text));
    box();

    expectWords
    (
        errorOfCad(name), {name.c_str(), "finds no faces", "Could not read"}
    );
    EXPECT_EQ(contentsOf("broken.step"), text);
}


TEST_F(cadSurfaceTest, aBoxIsInMetres)
{
    const wallSurface wall(read(box("box.Stp")));

    EXPECT_TRUE(findWallDefects(wall).empty());
    EXPECT_NEAR(testSurfaces::enclosedVolume(wall), 6e-6, 1e-15);
    EXPECT_EQ(wall.patchNames.size(), 6);
    EXPECT_EQ(wall.patchNames[5], "face6");
    ASSERT_EQ(reading_.cadFiles.size(), 1);
    EXPECT_EQ(reading_.cadFiles[0].find("box.Stp: unit: millimetre; "), 0u)
        << reading_.cadFiles[0];
}


TEST_F(cadSurfaceTest, edgesAreAtMostSoLong)
{
    // Edges of 3 m after the scale
    controls_.scale = 1000;
    controls_.cad.maxEdge = 3;
    const wallSurface wall(read(box()));
    scalar longest = 0;

    for (const face& f : wall.faces)
    {
        forAll(f, i)
        {
            longest = max(longest, f.faceEdge(i).mag(wall.points));
        }
    }

    EXPECT_NEAR(testSurfaces::enclosedVolume(wall), 6000, 1e-6);
    EXPECT_LT(longest, 4.5);
    EXPECT_GT(longest, 2.5);
}


TEST_F(cadSurfaceTest, solidsStandBesideTriangles)
{
    const fileNameList files
    ({
        file("cube.stl", translated(cube(2), vector(3, 0, 0))), box()
    });
    const wallSurface wall(readWallSurface(files, controls_, reading_));

    EXPECT_TRUE(findWallDefects(wall).empty());
    EXPECT_EQ(wall.patchNames.size(), 7);
    EXPECT_NEAR(testSurfaces::enclosedVolume(wall), 1 + 6e-6, 1e-9);
}


// ************************************************************************* //
