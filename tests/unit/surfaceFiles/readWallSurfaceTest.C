/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceFiles.H"
#include "wallDefects.H"

using namespace Foam;
using namespace Foam::testSurfaces;

typedef surfaceFiles readWallSurfaceFiles;

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

    for (const word name : {"body.vtk", "body.off"})
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

    EXPECT_EQ(read(name).points.size(), 5);
    EXPECT_EQ(reading_.nearPoints, 1);

    controls_.mergeTolerance = 1e-7;
    EXPECT_EQ(read(name).points.size(), 5);

    controls_.mergeTolerance = 1e-5;
    EXPECT_EQ(read(name).points.size(), 4);
    EXPECT_EQ(reading_.nearPoints, 0);
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

    controls_.mergeTolerance = 1e-9;
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
    for (const word name : {"a.obj", "b.stl", "c.off"})
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


TEST_F(readWallSurfaceFiles, surfaceIsScaled)
{
    controls_.scale = 0.001;
    EXPECT_NEAR
    (
        testSurfaces::enclosedVolume(read(file("body.obj", cube(2)))),
        1e-9, 1e-20
    );
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


// ************************************************************************* //
