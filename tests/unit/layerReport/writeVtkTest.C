/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/


#include "writeVtk.H"
#include "error.H"
#include "OSspecific.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- A folder that goes with the test
class temporaryFolder
{
    fileName path_;

public:

    temporaryFolder()
    {
        char path[] = "/tmp/writeVtkTestXXXXXX";
        path_ = fileName(mkdtemp(path));
    }

    ~temporaryFolder()
    {
        rmDir(path_);
    }

    fileName operator/(const word& name) const
    {
        return path_/name;
    }
};


//- Reads what a legacy VTK reader would
class vtkFile
{
    std::istringstream is_;

    void read(char* bytes, const int size)
    {
        is_.read(bytes, size);

        #if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
        std::reverse(bytes, bytes + size);
        #endif
    }

public:

    explicit vtkFile(const fileName& file)
    {
        std::ifstream is(file, std::ios::binary);
        std::ostringstream all;
        all << is.rdbuf();
        is_.str(all.str());
    }

    std::string line()
    {
        std::string text;
        std::getline(is_, text);
        return text;
    }

    scalarList numbers(const label size)
    {
        scalarList values(size);
        for (scalar& value : values)
        {
            char bytes[8];
            double number;
            read(bytes, 8);
            std::memcpy(&number, bytes, 8);
            value = number;
        }
        is_.get();
        return values;
    }

    labelList labels(const label size)
    {
        labelList values(size);
        for (label& value : values)
        {
            char bytes[4];
            int32_t number;
            read(bytes, 4);
            std::memcpy(&number, bytes, 4);
            value = number;
        }
        is_.get();
        return values;
    }

    bool atEnd()
    {
        return is_.peek() == std::istringstream::traits_type::eof();
    }
};


//- A tetrahedron and one of its edges
static vtkGrid testGrid()
{
    vtkGrid grid;
    grid.points = pointField
    ({
        point(0, 0, 0), point(1, 0, 0), point(0, 1, 0), point(0.1, 0.2, 1e-9)
    });
    grid.addCell(vtkCell::tetra, labelList({0, 1, 2, 3}));
    grid.addCell(vtkCell::polyLine, labelList({1, 2}));

    return grid;
}


static void skipHeader(vtkFile& file)
{
    for (label i = 0; i < 4; ++i)
    {
        file.line();
    }
}


static void skipGrid(vtkFile& file)
{
    skipHeader(file);
    file.line();
    file.numbers(12);
    file.line();
    file.labels(8);
    file.line();
    file.labels(2);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(writeVtk, header)
{
    const temporaryFolder folder;
    writeVtk(folder/"grid.vtk", testGrid());
    vtkFile file(folder/"grid.vtk");

    EXPECT_EQ(file.line(), "# vtk DataFile Version 2.0");
    EXPECT_EQ(file.line(), "harmonicPrismMesh");
    EXPECT_EQ(file.line(), "BINARY");
    EXPECT_EQ(file.line(), "DATASET UNSTRUCTURED_GRID");
}


TEST(writeVtk, pointsAndCells)
{
    const temporaryFolder folder;
    writeVtk(folder/"grid.vtk", testGrid());
    vtkFile file(folder/"grid.vtk");
    skipHeader(file);

    EXPECT_EQ(file.line(), "POINTS 4 double");
    EXPECT_EQ
    (
        file.numbers(12),
        scalarList({0, 0, 0, 1, 0, 0, 0, 1, 0, 0.1, 0.2, 1e-9})
    );
    EXPECT_EQ(file.line(), "CELLS 2 8");
    EXPECT_EQ(file.labels(8), labelList({4, 0, 1, 2, 3, 2, 1, 2}));
    EXPECT_EQ(file.line(), "CELL_TYPES 2");
    EXPECT_EQ(file.labels(2), labelList({10, 4}));
    EXPECT_TRUE(file.atEnd());
}


TEST(writeVtk, fields)
{
    vtkGrid grid(testGrid());
    grid.pointFields.add("H", scalarField({1, 0.5, 0.25, 0}));
    grid.pointFields.add("direction", vectorField(4, vector(1, 2, 3)));
    grid.cellFields.add("T", List<symmTensor>(2, symmTensor(1, 2, 3, 4, 5, 6)));

    const temporaryFolder folder;
    writeVtk(folder/"grid.vtk", grid);
    vtkFile file(folder/"grid.vtk");
    skipGrid(file);

    EXPECT_EQ(file.line(), "POINT_DATA 4");
    EXPECT_EQ(file.line(), "FIELD attributes 2");
    EXPECT_EQ(file.line(), "H 1 4 double");
    EXPECT_EQ(file.numbers(4), scalarList({1, 0.5, 0.25, 0}));
    EXPECT_EQ(file.line(), "direction 3 4 double");
    EXPECT_EQ
    (
        file.numbers(12),
        scalarList({1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3})
    );
    EXPECT_EQ(file.line(), "CELL_DATA 2");
    EXPECT_EQ(file.line(), "FIELD attributes 1");
    EXPECT_EQ(file.line(), "T 9 2 double");
    EXPECT_EQ
    (
        file.numbers(18),
        scalarList({1, 2, 3, 2, 4, 5, 3, 5, 6, 1, 2, 3, 2, 4, 5, 3, 5, 6})
    );
    EXPECT_TRUE(file.atEnd());
}


TEST(writeVtk, largeArrays)
{
    vtkGrid grid;
    grid.points = pointField(200000, point(1, 2, 3));
    grid.points.last() = point(4, 5, 6);

    const temporaryFolder folder;
    writeVtk(folder/"grid.vtk", grid);
    vtkFile file(folder/"grid.vtk");
    skipHeader(file);

    EXPECT_EQ(file.line(), "POINTS 200000 double");
    EXPECT_EQ(file.numbers(600000).last(), 6);
    EXPECT_EQ(file.line(), "CELLS 0 0");
}


TEST(writeVtk, refusesFieldsOfOtherSizes)
{
    vtkGrid grid(testGrid());
    grid.pointFields.add("H", scalarField(3, 1.0));

    const temporaryFolder folder;

    EXPECT_THROW(writeVtk(folder/"grid.vtk", grid), Foam::error);
}


TEST(writeVtk, refusesFilesThatCannotBeWritten)
{
    const temporaryFolder folder;

    EXPECT_THROW(writeVtk(folder/"none"/"grid.vtk", testGrid()), Foam::IOerror);
}


// ************************************************************************* //
