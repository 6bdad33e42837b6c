/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismQuality.H"
#include "cellPredicates.H"
#include "Random.H"

#include <gtest/gtest.h>

#include <string>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- One cell between columns with these upper ends: first one on each point of
//  the wall, then the further ones
static prismLayers cellBetween
(
    const pointField& wallPoints,
    const labelList& extraColumnPoints,
    const pointField& upper,
    const face& columns
)
{
    prismLayers layers;
    layers.nLayers = 1;
    layers.extraColumnPoints = extraColumnPoints;
    layers.faces = faceList(1, columns);
    layers.points.setSize(2*upper.size());

    forAll(upper, c)
    {
        layers.points[2*c] = wallPoints[layers.root(c)];
        layers.points[2*c + 1] = upper[c];
    }

    return layers;
}


//- The prism between a column on the point at y = 1 and two on the origin:
//  columns 0 and 2 on the latter, seen from above to the right and the left
static prismLayers wedge()
{
    return cellBetween
    (
        pointField({{0, 0, 0}, {0, 1, 0}}),
        labelList(1, 0),
        pointField({{1, -0.2, 0.8}, {0.1, 1.1, 1}, {-1, -0.1, 0.9}}),
        face({0, 1, 2})
    );
}


//- The points of the wedge: on the wall, then the upper ones
static pointField wedgePoints(const prismLayers& cell)
{
    return pointField
    ({
        cell(0, 0), cell(1, 0), cell(0, 1), cell(1, 1), cell(2, 1)
    });
}


static void setWedgePoints(prismLayers& cell, const pointField& x)
{
    cell.points = pointField({x[0], x[2], x[1], x[3], x[0], x[4]});
}


//- The signs of the five tetrahedra on four of five points, each by the point
//  it does not have
static List<int> tetrahedronSigns(const pointField& x)
{
    return List<int>
    ({
        orientation(x[1], x[2], x[3], x[4]),
        orientation(x[0], x[2], x[3], x[4]),
        orientation(x[0], x[1], x[3], x[4]),
        orientation(x[0], x[1], x[2], x[4]),
        orientation(x[0], x[1], x[2], x[3])
    });
}


//- Some point in the plane of those that are neither a nor b
static point pointInPlane
(
    const pointField& x,
    const label a,
    const label b,
    Random& random
)
{
    point sum(Zero);
    scalar sumWeights = 0;

    for (label q = 0; q < 5; ++q)
    {
        if (q != a && q != b)
        {
            const scalar weight = random.position<scalar>(-0.5, 1);
            sumWeights += weight;
            sum += weight*x[q];
        }
    }

    return sum/sumWeights;
}


//- The prism between three columns on the origin
static prismLayers tetrahedron()
{
    return cellBetween
    (
        pointField(1, point(Zero)),
        labelList({0, 0}),
        pointField({{1, 0, 0.5}, {-0.5, 1, 0.5}, {-0.5, -1, 0.5}}),
        face({0, 1, 2})
    );
}


//- The prism that lies on the edge from the origin to y = 1, with two columns
//  on each of its ends: 0 and 2, 1 and 3
static prismLayers lyingPrism()
{
    return cellBetween
    (
        pointField({{0, 0, 0}, {0, 1, 0}}),
        labelList({0, 1}),
        pointField({{1, 0, 1}, {1, 1, 1}, {-1, 0, 1}, {-1, 1, 1}}),
        face({0, 1, 3, 2})
    );
}


static std::string name(const prismLayers& cell)
{
    return std::to_string(cell.nColumns()) + " columns on "
      + std::to_string(cell.nWallPoints()) + " points";
}


static prismLayers mirroredCell(prismLayers layers)
{
    for (point& p : layers.points)
    {
        p.x() = -p.x();
    }

    return layers;
}


//- The same face from each of its points
static List<prismLayers> turned(const prismLayers& cell)
{
    List<prismLayers> all(cell.faces[0].size(), cell);

    forAll(all, k)
    {
        face& f = all[k].faces[0];

        forAll(f, i)
        {
            f[i] = cell.faces[0][(i + k) % f.size()];
        }
    }

    return all;
}


//- The upper end of column c far below the others
static prismLayers sunk(prismLayers cell, const label c)
{
    cell.points[cell.index(c, 1)].z() -= 10;

    return cell;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(isPositive, cellsBetweenColumnsOnAPoint)
{
    for (const prismLayers& cell : {wedge(), tetrahedron(), lyingPrism()})
    {
        EXPECT_TRUE(isPositive(cell, 0, 1)) << name(cell);
    }
}


TEST(isPositive, mirrorImagesOfTheseAreNot)
{
    for (const prismLayers& cell : {wedge(), tetrahedron(), lyingPrism()})
    {
        EXPECT_FALSE(isPositive(mirroredCell(cell), 0, 1)) << name(cell);
    }
}


TEST(isPositive, firstPointOfAFaceDoesNotMatter)
{
    for (const prismLayers& cell : {wedge(), tetrahedron(), lyingPrism()})
    {
        for (const prismLayers& same : turned(cell))
        {
            EXPECT_TRUE(isPositive(same, 0, 1)) << name(same);
            EXPECT_FALSE(isPositive(mirroredCell(same), 0, 1)) << name(same);
        }
    }
}


TEST(isPositive, everyColumnOfTheseCounts)
{
    for (const prismLayers& cell : {wedge(), tetrahedron(), lyingPrism()})
    {
        for (const label c : cell.faces[0])
        {
            EXPECT_FALSE(isPositive(sunk(cell, c), 0, 1)) << name(cell);
        }
    }
}


TEST(isPositive, columnsThatCoincideHaveNothingBetweenThem)
{
    for (prismLayers cell : {wedge(), tetrahedron(), lyingPrism()})
    {
        const label last = cell.nColumns() - 1;
        const point& other = cell(cell.root(last), 1);
        cell.points[cell.index(last, 1)] = other;

        EXPECT_FALSE(isPositive(cell, 0, 1)) << name(cell);
    }
}


TEST(isPositive, everyTetrahedronOfAWedgeCounts)
{
    const pointField x(wedgePoints(wedge()));
    const List<int> signs(tetrahedronSigns(x));
    labelList nTurned(5, 0);
    Random random(17);

    for (label i = 0; i < 2000; ++i)
    {
        // A point through the plane of three others, and not of any else
        const label p = random.position<label>(0, 4);
        const label without = (p + random.position<label>(1, 4)) % 5;
        pointField y(x);
        y[p] += 1.01*(pointInPlane(x, p, without, random) - x[p]);

        List<int> turned(signs);
        turned[without] = -turned[without];

        if (tetrahedronSigns(y) == turned)
        {
            prismLayers cell(wedge());
            setWedgePoints(cell, y);
            ++nTurned[without];

            EXPECT_FALSE(isPositive(cell, 0, 1)) << p << ' ' << without;
        }
    }

    EXPECT_GE(min(nTurned), 1);
}


TEST(isPositive, wedgeStaysSoUpToThePlanes)
{
    const pointField x(wedgePoints(wedge()));
    const List<int> signs(tetrahedronSigns(x));
    label n = 0;

    for (label p = 2; p < 5; ++p)
    {
        for (scalar t = -1; t < 1; t += 0.02)
        {
            for (direction d = 0; d < 3; ++d)
            {
                prismLayers cell(wedge());
                pointField y(x);
                y[p][d] += t;
                setWedgePoints(cell, y);
                const bool unturned = tetrahedronSigns(y) == signs;
                n += unturned;

                EXPECT_EQ(isPositive(cell, 0, 1), unturned);
            }
        }
    }

    EXPECT_GT(n, 0);
}


TEST(isPositive, tetrahedronIsWhatIsBetweenThreeColumnsOnAPoint)
{
    for (label c = 0; c < 3; ++c)
    {
        for (scalar t = -3; t < 3; t += 0.07)
        {
            for (direction d = 0; d < 3; ++d)
            {
                prismLayers cell(tetrahedron());
                cell.points[cell.index(c, 1)][d] += t;

                EXPECT_EQ
                (
                    isPositive(cell, 0, 1),
                    orientation
                    (
                        cell(0, 0), cell(0, 1), cell(1, 1), cell(2, 1)
                    ) > 0
                );
            }
        }
    }
}


TEST(isPositive, lyingPrismMayBeTwisted)
{
    // As long as its corners are positive and one of the ways to cut it is
    for (const scalar shift : {-0.3, 0.3})
    {
        prismLayers cell(lyingPrism());
        cell.points[cell.index(0, 1)].z() += shift;
        cell.points[cell.index(3, 1)].z() += shift;

        EXPECT_TRUE(isPositive(cell, 0, 1));
    }
}


TEST(isPositive, cornersOfALyingPrismCount)
{
    // The columns on one point change sides
    prismLayers cell(lyingPrism());
    Swap(cell.points[cell.index(0, 1)], cell.points[cell.index(2, 1)]);

    EXPECT_FALSE(isPositive(cell, 0, 1));
}


// ************************************************************************* //
