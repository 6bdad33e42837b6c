/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "MeshedSurfaces.H"
#include "OSspecific.H"
#include "readWallSurface.H"
#include "testSurfaces.H"
#include "wallDefects.H"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

class readWallSurfaceFiles
:
    public testing::Test
{
protected:

    fileName folder_;
    wallSurfaceControls controls_;
    wallReading reading_;

    void SetUp() override
    {
        char path[] = "/tmp/readWallSurfaceXXXXXX";
        ASSERT_NE(mkdtemp(path), nullptr);
        folder_ = path;
    }

    void TearDown() override
    {
        rmDir(folder_);
    }

    //- A file of the text in the folder
    fileName file(const word& name, const std::string& text) const
    {
        std::ofstream(folder_/name, std::ios::binary) << text;

        return folder_/name;
    }

    //- The surface as a file in the format of the extension
    fileName file(const word& name, const wallSurface& wall) const
    {
        if (name.ext() == "off")
        {
            return file(name, offText(wall));
        }

        const unsigned int digits = IOstream::defaultPrecision(17);
        meshedSurface
        (
            pointField(wall.points), faceList(wall.faces)
        ).write(folder_/name);
        IOstream::defaultPrecision(digits);

        return folder_/name;
    }

    //- OpenFOAM's writer forgets faces without zones
    static std::string offText(const wallSurface& wall)
    {
        std::ostringstream os;
        os  << "OFF\n" << wall.points.size() << ' ' << wall.faces.size()
            << " 0\n";

        for (const point& p : wall.points)
        {
            os  << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
        }

        for (const face& f : wall.faces)
        {
            os  << f.size();
            for (const label p : f)
            {
                os  << ' ' << p;
            }
            os  << '\n';
        }

        return os.str();
    }

    wallSurface read(const fileName& name)
    {
        return readWallSurface(name, controls_, reading_);
    }

    //- The message of the error that reading throws
    std::string errorOf(const fileName& name)
    {
        try
        {
            read(name);
        }
        catch (const Foam::error& e)
        {
            return e.message();
        }

        return "no error";
    }

    //- The error names the file and what is wrong
    void expectError(const fileName& name, const char* what)
    {
        const std::string message(errorOf(name));
        EXPECT_NE(message.find(name), std::string::npos) << message;
        EXPECT_NE(message.find(what), std::string::npos) << message;
    }
};


//- A tetrahedron
static const char* tetPoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";


//- Binary STL of a tetrahedron
static std::string binaryTet(const uint32_t nFacets = 4)
{
    const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int f[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    const float normal[3] = {0, 0, 0};
    const uint16_t attribute = 0;

    const auto bytes = [](const void* data, const size_t n)
    {
        return std::string(static_cast<const char*>(data), n);
    };

    std::string text("solid, as some programs write into binary files");
    text.resize(80, ' ');
    text += bytes(&nFacets, 4);

    for (const auto& facet : f)
    {
        text += bytes(normal, 12);
        for (const int i : facet)
        {
            text += bytes(p[i], 12);
        }
        text += bytes(&attribute, 2);
    }

    return text;
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_F(readWallSurfaceFiles, objKeepsPointsFacesAndOrder)
{
    const wallSurface wall(quadCube(3));
    const wallSurface read_(read(file("body.obj", wall)));

    EXPECT_EQ(read_.faces, wall.faces);
    EXPECT_EQ(read_.points.size(), wall.points.size());
    EXPECT_LT(max(mag(read_.points - wall.points)), 1e-15);
}


TEST_F(readWallSurfaceFiles, vtkAndOffAreRead)
{
    const wallSurface wall(quadCube(2));

    for (const word& name : {"body.vtk", "body.off"})
    {
        const wallSurface read_(read(file(name, wall)));
        EXPECT_EQ(read_.faces, wall.faces);
        EXPECT_EQ(read_.patchNames, wordList(1, word("body")));
        EXPECT_TRUE(findWallDefects(read_).empty());
    }
}


TEST_F(readWallSurfaceFiles, objGroupsArePatches)
{
    const fileName name
    (
        file
        (
            "body.obj",
            std::string(tetPoints)
          + "g hull\nf 1 3 2\nf 1 2 4\ng empty\ng 2nd side\nf 2 3 4\n"
            "g hull\nf 1 4 3\n"
        )
    );
    const wallSurface wall(read(name));

    EXPECT_EQ(wall.patchNames, wordList({"hull", "_2nd"}));
    EXPECT_EQ(wall.patchIDs, labelList({0, 0, 0, 1}));
    EXPECT_TRUE(findWallDefects(wall).empty());
}


TEST_F(readWallSurfaceFiles, onlyPatchWithoutNameIsNamedAfterTheFile)
{
    EXPECT_EQ
    (
        read(file("body.v2.obj", cube(1))).patchNames,
        wordList(1, word("body.v2"))
    );
    EXPECT_EQ
    (
        read(file("3body.stl", cube(1))).patchNames,
        wordList(1, word("_3body"))
    );
}


TEST_F(readWallSurfaceFiles, stlPointsAreMerged)
{
    const wallSurface wall(sphere(4));
    const wallSurface read_(read(file("body.stl", wall)));

    EXPECT_EQ(read_.points.size(), wall.points.size());
    EXPECT_EQ(reading_.mergedPoints, 3*wall.faces.size() - wall.points.size());
    EXPECT_EQ(reading_.collapsedFaces, 0);
    EXPECT_TRUE(findWallDefects(read_).empty());
}


TEST_F(readWallSurfaceFiles, mergeToleranceIsRelativeToTheDiagonal)
{
    // The second facet's copy of a point is 1e-4 off
    const fileName name
    (
        file
        (
            "body.stl",
            "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n"
            "vertex 100 0 0\nvertex 0 100 0\nendloop\nendfacet\n"
            "facet normal 0 0 0\nouter loop\nvertex 100 0 0\n"
            "vertex 0 1e-4 0\nvertex 0 0 100\nendloop\nendfacet\nendsolid a\n"
        )
    );

    controls_.mergeTolerance = 1e-7;
    EXPECT_EQ(read(name).points.size(), 5);

    controls_.mergeTolerance = 1e-5;
    EXPECT_EQ(read(name).points.size(), 4);
}


TEST_F(readWallSurfaceFiles, stlFacesWithMergedCornersGo)
{
    std::string text("solid a\n");
    const auto facet = [&](const std::string& a, const std::string& b)
    {
        text +=
            "facet normal 0 0 0\nouter loop\nvertex 0 0 1\nvertex " + a
          + "\nvertex " + b + "\nendloop\nendfacet\n";
    };
    facet("0 0 0", "1 0 0");
    facet("1 0 0", "1 1e-20 0");
    facet("1 0 0", "0 1 0");

    EXPECT_EQ(read(file("body.stl", text + "endsolid a\n")).faces.size(), 2);
    EXPECT_EQ(reading_.collapsedFaces, 1);
}


TEST_F(readWallSurfaceFiles, binaryStlIsReadWhateverItsHeader)
{
    const wallSurface wall(read(file("tet.stl", binaryTet())));

    EXPECT_EQ(wall.points.size(), 4);
    EXPECT_EQ(wall.faces.size(), 4);
    EXPECT_EQ(wall.patchNames, wordList(1, word("tet")));
    EXPECT_TRUE(findWallDefects(wall).empty());
}


TEST_F(readWallSurfaceFiles, compressedFilesAreRead)
{
    for (const word& name : {"a.obj", "b.stl", "c.off"})
    {
        const fileName plain(file(name, cube(2)));
        const std::string gzip("gzip " + plain);
        ASSERT_EQ(std::system(gzip.c_str()), 0);

        EXPECT_EQ(read(plain).faces.size(), 48);
        const wallSurface wall(read(plain + ".gz"));
        EXPECT_EQ(wall.faces.size(), 48);
        EXPECT_EQ(wall.patchNames, wordList(1, name.lessExt()));
    }
}


TEST_F(readWallSurfaceFiles, compressedFileBesideAnotherIsRefused)
{
    const fileName plain(file("a.obj", cube(1)));
    const std::string gzip("gzip -k " + plain);
    ASSERT_EQ(std::system(gzip.c_str()), 0);

    expectError(plain + ".gz", "beside it");
}


TEST_F(readWallSurfaceFiles, surfaceIsScaled)
{
    controls_.scale = 0.001;
    EXPECT_NEAR(enclosedVolume(read(file("body.obj", cube(2)))), 1e-9, 1e-20);
}


TEST_F(readWallSurfaceFiles, unusedPointsGo)
{
    const fileName name
    (
        file
        (
            "body.obj",
            "v 9 9 9\n" + std::string(tetPoints)
          + "f 2 4 3\nf 2 3 5\nf 3 4 5\nf 2 5 4\n"
        )
    );

    EXPECT_EQ(read(name).points.size(), 4);
    EXPECT_EQ(read(name).points[0], point::zero);
}


TEST_F(readWallSurfaceFiles, wrongFilesAreNamed)
{
    const std::string tet(tetPoints);

    expectError(folder_/"none.obj", "no such file");
    expectError(folder_, "no such file");
    expectError(file("body.xyz", tet), "unknown extension");
    expectError(file("body", tet), "unknown extension");
    expectError(file("empty.obj", ""), "empty");
    expectError(file("empty.stl", ""), "empty");
    expectError(file("points.obj", tet), "no faces");
    expectError(file("none.stl", "solid a\nendsolid a\n"), "no faces");
}


TEST_F(readWallSurfaceFiles, wrongPointsAreNamed)
{
    const std::string tet(tetPoints);

    expectError(file("far.obj", tet + "f 1 2 5\n"), "refers to point 4 of 4");
    expectError(file("back.obj", tet + "f -1 -2 -3\n"), "relative");
    expectError(file("flat.obj", "v 0 0 0\nv 1 2\nf 1 2 1\n"), "line 2");
    expectError(file("word.obj", "v 0 0 x\n" + tet + "f 1 2 3\n"), "'x'");
    expectError
    (
        file("nan.obj", "v 0 nan 0\n" + tet + "f 1 2 3\n"),
        "not finite"
    );
    expectError
    (
        file("inf.obj", "v 0 0 1e99\n" + tet + "f 1 2 3\n"),
        "not finite"
    );
}


TEST_F(readWallSurfaceFiles, pointThatIsNotFiniteHasItsPlace)
{
    const fileName name
    (
        file("inf.obj", "v 0 0 0\nv 1 0 0\nv 0 1e200 0\nf 1 2 3\n")
    );

    expectError(name, "point 2 at (0 1e+200 0)");
}


TEST_F(readWallSurfaceFiles, brokenStlIsRefused)
{
    const std::string whole(binaryTet());

    for (const size_t n : {10, 90, 100, 150, 230, 283})
    {
        std::string part(whole.substr(0, n));
        expectError(file("solid.stl", part), "");

        part[0] = 'x';
        expectError(file("body.stl", part), "truncated");
    }

    expectError(file("few.stl", "x" + binaryTet(3).substr(1)), "truncated");
    expectError(file("text.stl", "facet normal 0 0 1\n"), "solid");
    expectError
    (
        file
        (
            "quad.stl",
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
            "vertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n"
            "endsolid a\n"
        ),
        "three points"
    );
    expectError
    (
        file
        (
            "cut.stl",
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
        ),
        "three points"
    );
}


TEST_F(readWallSurfaceFiles, garbageIsRefused)
{
    std::string garbage;
    for (label i = 0; i < 1000; ++i)
    {
        garbage += char(37*i*i + 11*i + 1);
    }

    for (const word& extension : {"obj", "off", "stl", "vtk"})
    {
        expectError(file("garbage." + extension, garbage), "");
    }

    expectError(file("huge.off", "OFF\n2000000000 4 0\n0 0 0\n"), "");
    expectError(file("minus.off", "OFF\n-4 -4 0\n"), "");
    expectError(file("short.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n"), "");
}


TEST_F(readWallSurfaceFiles, fatalErrorsStayAsTheyWere)
{
    const bool throwing = FatalError.throwing();
    errorOf(file("empty.off", "OFF\n"));

    EXPECT_EQ(FatalError.throwing(), throwing);
}


// ************************************************************************* //
