/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceFiles.H"

using namespace Foam;
using namespace Foam::testSurfaces;

typedef surfaceFiles brokenSurfaceFiles;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_F(brokenSurfaceFiles, compressedFileBesideAnotherIsRefused)
{
    const fileName plain(file("a.obj", cube(1)));
    const std::string gzip("gzip -k " + plain);
    ASSERT_EQ(std::system(gzip.c_str()), 0);

    expectError(plain + ".gz", "instead");
}


TEST_F(brokenSurfaceFiles, wrongFilesAreNamed)
{
    const std::string tet(tetPoints);

    expectError(folder_/"none.obj", "no such file");
    expectError(folder_, "no such file");
    expectError(file("body.xyz", tet), "unknown extension");
    expectError(file("body", tet), "unknown extension");
    expectError(file("body.step.gz", ""), "CAD is not read compressed");
    expectError(file("empty.obj", ""), "empty");
    expectError(file("empty.stl", ""), "empty");
    expectError(file("points.obj", tet), "no faces");
    expectError(file("none.stl", "solid a\nendsolid a\n"), "no faces");
}


TEST_F(brokenSurfaceFiles, wrongPointsAreNamed)
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


TEST_F(brokenSurfaceFiles, pointThatIsNotFiniteHasItsPlace)
{
    const fileName name
    (
        file("inf.obj", "v 0 0 0\nv 1 0 0\nv 0 1e200 0\nf 1 2 3\n")
    );

    expectError(name, "point 2 at (0 1e+200 0)");
}


TEST_F(brokenSurfaceFiles, brokenStlIsRefused)
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


TEST_F(brokenSurfaceFiles, garbageIsRefused)
{
    std::string garbage;
    for (label i = 0; i < 1000; ++i)
    {
        garbage += char(37*i*i + 11*i + 1);
    }

    for (const word extension : {"obj", "off", "stl", "vtk"})
    {
        expectError(file("garbage." + extension, garbage), "");
    }

    expectError(file("huge.off", "OFF\n2000000000 4 0\n0 0 0\n"), "");
    expectError(file("minus.off", "OFF\n-4 -4 0\n"), "");
    expectError(file("short.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n"), "");
}


TEST_F(brokenSurfaceFiles, crashOfAReaderIsAnError)
{
    // Sizes that OpenFOAM's reader believes
    expectError
    (
        file
        (
            "sizes.vtk",
            "# vtk DataFile Version 2.0\ntitle\nASCII\nDATASET POLYDATA\n"
            "POINTS 4 float\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n\n"
            "POLYGONS 40 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"
        ),
        ""
    );
}


TEST_F(brokenSurfaceFiles, fatalErrorsStayAsTheyWere)
{
    const bool throwing = FatalError.throwing();
    errorOf(file("empty.off", "OFF\n"));

    EXPECT_EQ(FatalError.throwing(), throwing);
}


// ************************************************************************* //
