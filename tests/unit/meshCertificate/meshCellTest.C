/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCell.H"
#include "prismPolyMesh.H"
#include "testLayers.H"
#include "testStages.H"
#include "unitConversion.H"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- One cell, its faces seen from outside
struct oneCell
{
    pointField points;
    faceList faces;

    meshCellVerdict verdict(const labelList& onWall = labelList()) const
    {
        const labelList owner(faces.size(), Zero);
        const labelList neighbour;
        const polyhedralMesh mesh(points, faces, owner, neighbour);
        boolList isOnWall(points.size(), false);

        for (const label p : onWall)
        {
            isOnWall[p] = true;
        }

        return meshCell(mesh, isOnWall)(0);
    }

    meshCellShape shape() const
    {
        return verdict().shape;
    }

    bool positive() const
    {
        return verdict().positive;
    }
};


static oneCell onPolygon(const label n)
{
    const prismLayers layers(testSurfaces::onePolygon(n, scalarList({0, 1})));
    return oneCell{layers.points, makePrismTopology(layers).faces};
}


static oneCell tet()
{
    return oneCell
    {
        pointField
        ({
            point(0, 0, 0), point(1, 0, 0), point(0, 1, 0), point(0, 0, 1)
        }),
        faceList
        ({
            face({0, 2, 1}), face({0, 1, 3}), face({1, 2, 3}), face({2, 0, 3})
        })
    };
}


static oneCell pyramid()
{
    return oneCell
    {
        pointField
        ({
            point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0),
            point(0.5, 0.5, 1)
        }),
        faceList
        ({
            face({0, 3, 2, 1}), face({0, 1, 4}), face({1, 2, 4}),
            face({2, 3, 4}), face({3, 0, 4})
        })
    };
}


//- Between two columns on point 0 and one, to point 2, on point 1
static oneCell wedge()
{
    return oneCell
    {
        pointField
        ({
            point(0, 0, 0), point(1, 0, 0), point(1, 0, 1),
            point(0, 0.5, 0.9), point(0, -0.5, 0.9)
        }),
        faceList
        ({
            face({0, 1, 2, 4}), face({1, 0, 3, 2}), face({0, 4, 3}),
            face({3, 4, 2})
        })
    };
}


//- A cube of which one side is four faces, as beside smaller cubes
static oneCell refinedCube()
{
    return oneCell
    {
        pointField
        ({
            point(0, 0, 0), point(2, 0, 0), point(2, 2, 0), point(0, 2, 0),
            point(0, 0, 2), point(2, 0, 2), point(2, 2, 2), point(0, 2, 2),
            point(1, 0, 2), point(2, 1, 2), point(1, 2, 2), point(0, 1, 2),
            point(1, 1, 2)
        }),
        faceList
        ({
            face({0, 3, 2, 1}), face({0, 1, 5, 8, 4}), face({1, 2, 6, 9, 5}),
            face({2, 3, 7, 10, 6}), face({3, 0, 4, 11, 7}),
            face({4, 8, 12, 11}), face({8, 5, 9, 12}), face({12, 9, 6, 10}),
            face({11, 12, 10, 7})
        })
    };
}


//- A cube with a point within one edge
static oneCell cubeWithPoint()
{
    oneCell cell(refinedCube());
    cell.points.setSize(9);
    cell.faces = faceList
    ({
        face({0, 3, 2, 1}), face({0, 1, 5, 8, 4}), face({1, 2, 6, 5}),
        face({2, 3, 7, 6}), face({3, 0, 4, 7}), face({4, 8, 5, 6, 7})
    });

    return cell;
}


static std::vector<oneCell> shapes()
{
    return
    {
        onPolygon(3), onPolygon(4), onPolygon(5), onPolygon(6), tet(),
        pyramid(), wedge()
    };
}


//- The upper triangle is turned by an angle [deg]. Points 0, 2, 4 are below
//  1, 3, 5.
static oneCell twistedPrism(const scalar angle)
{
    oneCell cell(onPolygon(3));
    const scalar c = std::cos(degToRad(angle)), s = std::sin(degToRad(angle));

    for (label k = 1; k < 6; k += 2)
    {
        point& p = cell.points[k];
        p = point(c*p.x() - s*p.y(), s*p.x() + c*p.y(), p.z());
    }

    return cell;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(meshCell, shapesAreKnownByTheirFaces)
{
    EXPECT_EQ(onPolygon(3).shape(), meshCellShape::prism);
    EXPECT_EQ(onPolygon(4).shape(), meshCellShape::hexahedron);
    EXPECT_EQ(onPolygon(5).shape(), meshCellShape::other);
    EXPECT_EQ(tet().shape(), meshCellShape::tetrahedron);
    EXPECT_EQ(pyramid().shape(), meshCellShape::other);
    EXPECT_EQ(wedge().shape(), meshCellShape::wedge);
}


TEST(meshCell, positiveWhereverItIs)
{
    const tensor rotation(testSurfaces::rotation());

    for (oneCell cell : shapes())
    {
        EXPECT_TRUE(cell.positive()) << cell.faces.size() << " faces";

        for (point& p : cell.points)
        {
            p = (rotation & p) + vector(3, -5, 7);
        }
        EXPECT_TRUE(cell.positive()) << cell.faces.size() << " faces";
    }
}


TEST(meshCell, mirrorImagesAreNotPositive)
{
    for (oneCell cell : shapes())
    {
        const meshCellShape shape = cell.shape();

        for (point& p : cell.points)
        {
            p.z() = -p.z();
        }

        // Cells with as many points may be beside refined ones
        EXPECT_EQ
        (
            cell.shape(),
            cell.points.size() > 8 ? meshCellShape::polyhedron : shape
        );
        EXPECT_FALSE(cell.positive()) << cell.faces.size() << " faces";
    }
}


TEST(meshCell, flatCellsAreNotPositive)
{
    for (oneCell cell : shapes())
    {
        for (point& p : cell.points)
        {
            p.z() = 0;
        }

        EXPECT_FALSE(cell.positive()) << cell.faces.size() << " faces";
    }
}


TEST(meshCell, whereverTheFacesBegin)
{
    for (const oneCell& cell : shapes())
    {
        const label n = cell.faces.size();

        for (label i = 0; i < 12; ++i)
        {
            oneCell turned(cell);

            for (label j = 0; j < n; ++j)
            {
                face& f = turned.faces[j];
                f = cell.faces[(i + j)%n];

                std::rotate(f.begin(), f.begin() + (i/3 + j)%f.size(), f.end());
            }

            EXPECT_EQ(turned.shape(), cell.shape()) << n << " faces";
            EXPECT_TRUE(turned.positive()) << n << " faces";
        }
    }
}


TEST(meshCell, cellsBesideRefinedOnes)
{
    for (oneCell cell : {refinedCube(), cubeWithPoint()})
    {
        EXPECT_EQ(cell.shape(), meshCellShape::box);
        EXPECT_TRUE(cell.positive());

        oneCell mirrored(cell);
        for (point& p : mirrored.points)
        {
            p.x() = -p.x();
        }
        EXPECT_EQ(mirrored.shape(), meshCellShape::box);
        EXPECT_FALSE(mirrored.positive());

        for (point& p : cell.points)
        {
            p = testSurfaces::rotation() & p;
        }
        EXPECT_EQ(cell.shape(), meshCellShape::polyhedron);
        EXPECT_TRUE(cell.positive());

        for (point& p : cell.points)
        {
            p = -p;
        }
        EXPECT_FALSE(cell.positive());
    }
}


TEST(meshCell, foldedSidesAreNotPositive)
{
    // The point in the middle of the side is far beyond one of its edges
    oneCell cell(refinedCube());
    cell.points[12] = point(1, 3.5, 2);
    EXPECT_FALSE(cell.positive());

    cell.points[12] = point(1.9, 0.05, 2);
    EXPECT_TRUE(cell.positive());
}


TEST(meshCell, openCellsBesideRefinedOnesAreNotPositive)
{
    oneCell cell(refinedCube());
    cell.faces.setSize(cell.faces.size() - 1);
    EXPECT_FALSE(cell.positive());
}


TEST(meshCell, prismsByAllTetrahedra)
{
    // Beyond 60 degrees all corners are positive still
    EXPECT_TRUE(twistedPrism(59.9).positive());
    EXPECT_FALSE(twistedPrism(60.1).positive());
    EXPECT_FALSE(twistedPrism(-60.1).positive());
}


TEST(meshCell, lyingPrismsByOneWayOfCutting)
{
    const oneCell cell(twistedPrism(60.1));
    const meshCellVerdict onEdge(cell.verdict({2, 3}));

    EXPECT_EQ(onEdge.shape, meshCellShape::lyingPrism);
    EXPECT_TRUE(onEdge.positive);

    for (const labelList& onWall :
        {labelList({0, 2}), labelList({0, 2, 4}), labelList({0, 3})})
    {
        EXPECT_EQ(cell.verdict(onWall).shape, meshCellShape::prism);
        EXPECT_FALSE(cell.verdict(onWall).positive);
    }
}


TEST(meshCell, wedgesByAllTetrahedra)
{
    // The column on point 1 is between those on point 0
    for (const scalar y : {-0.9, -0.5, 0.5, 0.9})
    {
        oneCell cell(wedge());
        cell.points[2] = point(1, y, 0.9);
        EXPECT_FALSE(cell.positive()) << y;

        cell.points[2].y() *= 0.1;
        EXPECT_TRUE(cell.positive()) << y;
    }
}


TEST(meshCell, openCellsAreNotPositive)
{
    for (const oneCell& cell : shapes())
    {
        forAll(cell.faces, facei)
        {
            oneCell open(cell);
            open.faces[facei] = open.faces.last();
            open.faces.setSize(open.faces.size() - 1);
            EXPECT_FALSE(open.positive()) << facei;

            oneCell flipped(cell);
            flipped.faces[facei].flip();
            EXPECT_FALSE(flipped.positive()) << facei;
        }
    }
}


TEST(meshCell, notWithoutNumbers)
{
    for (oneCell cell : {onPolygon(3), onPolygon(4), tet(), wedge()})
    {
        cell.points[1].y() = std::numeric_limits<scalar>::quiet_NaN();
        EXPECT_FALSE(cell.positive()) << cell.faces.size() << " faces";
    }
}


// ************************************************************************* //
