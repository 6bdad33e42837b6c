/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readLocalHeights.H"
#include "testSurfaces.H"
#include "thrownMessage.H"

#include <cstdio>
#include <fstream>

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A file of the test, gone at its end
class testFile
{
    const fileName name_;

public:

    testFile(const std::string& name, const std::string& text)
    :
        name_(::testing::TempDir() + name)
    {
        std::ofstream(name_) << text;
    }

    ~testFile()
    {
        std::remove(name_.c_str());
    }

    operator const fileName&() const
    {
        return name_;
    }
};


//- Two triangles of the unit square
static const std::string square
(
    "# vtk DataFile Version 2.0\nsquare\nASCII\nDATASET POLYDATA\n"
    "POINTS 4 double\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "POLYGONS 2 8\n3 0 1 2\n3 0 2 3\n"
);


static surfaceValues readVtk(const std::string& text, const word& field)
{
    const testFile file("values.vtk", text);
    const autoPtr<Time> time(Time::New());

    return readVtkValues(file, field, time());
}


static bool has(const std::string& text, const char* part)
{
    return text.find(part) != std::string::npos;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(readVtkValues, fieldOfPoints)
{
    const surfaceValues read
    (
        readVtk
        (
            square + "POINT_DATA 4\nFIELD attributes 1\nh1 1 4 double\n"
            "1 2 3 4\n",
            "h1"
        )
    );

    EXPECT_EQ(read.surface.faces.size(), 2);
    EXPECT_EQ(read.values, scalarField({1, 2, 3, 4}));
}


TEST(readVtkValues, pointsHaveTheSmallestOfTheirCells)
{
    EXPECT_EQ
    (
        readVtk
        (
            square + "CELL_DATA 2\nFIELD attributes 1\nh1 1 2 double\n7 5\n",
            "h1"
        ).values,
        scalarField({5, 7, 5, 5})
    );
}


TEST(readVtkValues, namesWhatThereIs)
{
    const std::string message
    (
        thrownMessage<error>([]()
        {
            readVtk
            (
                square + "POINT_DATA 4\nFIELD attributes 1\nh1 1 4 double\n"
                "1 2 3 4\n",
                "h2"
            );
        })
    );

    EXPECT_TRUE(has(message, "no field h2")) << message;
    EXPECT_TRUE(has(message, "h1")) << message;
}


TEST(readVtkValues, refusesBinaryAndMissingFiles)
{
    std::string binary(square);
    binary.replace(binary.find("ASCII"), 5, "BINARY");

    EXPECT_TRUE
    (
        has
        (
            thrownMessage<error>([&]() { readVtk(binary, "h1"); }),
            "in ascii; ParaView"
        )
    );
    EXPECT_TRUE
    (
        has
        (
            thrownMessage<error>([&]()
            {
                const autoPtr<Time> time(Time::New());
                readVtkValues("/no/such.vtk", "h1", time());
            }),
            "no such file"
        )
    );
}


TEST(readListValues, ofPointsOrFaces)
{
    const testFile surface
    (
        "pyramid.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nv 0.5 0.5 -1\n"
        "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"
        "f 2 1 6\nf 3 2 6\nf 4 3 6\nf 1 4 6\n"
    );
    const testFile ofPoints("ofPoints", "(1 2 3 4 5 6)");
    const testFile ofFaces
    (
        "ofFaces",
        "FoamFile { version 2.0; format ascii; class scalarField;"
        " object ofFaces; }\n8(10 20 30 40 50 60 70 80)"
    );
    const testFile wrong("wrong", "(1 2 3)");

    const surfaceValues points(readListValues(ofPoints, surface, 2));
    EXPECT_EQ(points.values, scalarField({1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(points.surface.points[2], point(2, 2, 0));

    EXPECT_EQ
    (
        readListValues(ofFaces, surface, 1).values,
        scalarField({10, 10, 20, 30, 10, 50})
    );

    const std::string message
    (
        thrownMessage<error>([&]() { readListValues(wrong, surface, 1); })
    );
    EXPECT_TRUE(has(message, "3 values")) << message;
    EXPECT_TRUE(has(message, "6 points and 8 faces")) << message;
}


TEST(interpolate, unitOfLengthDoesNotMatter)
{
    surfaceValues source;
    source.surface = testSurfaces::cube(3);
    source.surface.points *= 1e-7;
    source.values = 1e7*source.surface.points.component(vector::Z);

    scalarField values;
    interpolate(source, pointField(1, point(1e-7, 0.55e-7, 0.63e-7)), values);
    EXPECT_NEAR(values[0], 0.63, 1e-9);
}


TEST(interpolate, isLinearOnTriangles)
{
    surfaceValues source;
    source.surface = testSurfaces::cube(3);
    for (const point& x : source.surface.points)
    {
        source.values.append(2 + x.x() - 3*x.y() + 5*x.z());
    }

    pointField points(testSurfaces::cube(7).points);
    scalarField values;
    EXPECT_NEAR(interpolate(source, points, values), 0, 1e-14);

    forAll(points, p)
    {
        const point& x = points[p];
        EXPECT_NEAR(values[p], 2 + x.x() - 3*x.y() + 5*x.z(), 1e-12);
    }

    points = pointField(1, point(0.5, 0.5, 1.25));
    EXPECT_NEAR(interpolate(source, points, values), 0.25, 1e-14);
    EXPECT_NEAR(values[0], 6, 1e-12);
}


// ************************************************************************* //
