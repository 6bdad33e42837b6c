/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerFront.H"
#include "saddles.H"
#include "testLayers.H"

#include <gtest/gtest.h>

#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- A wall and its front
struct dividedWall
{
    std::string name;
    wallSurface wall;
    layerFront front;


    dividedWall
    (
        const std::string& name,
        const wallSurface& wall,
        const scalar smallestAngle = 0
    )
    :
        name(name),
        wall(wall),
        front(testSurfaces::frontOf(wall, smallestAngle))
    {}


    label nExtraColumns() const
    {
        return front.wallPoints.size() - wall.points.size();
    }


    //- Points of the wall under a front face
    labelList onWall(const label facei) const
    {
        return labelList
        (
            UIndirectList<label>(front.wallPoints, front.surface.faces[facei])
        );
    }
};


//- Made once: all tests look at the same
static const std::vector<dividedWall>& walls()
{
    static std::vector<dividedWall> list;

    if (list.empty())
    {
        for (const testSurfaces::saddle& s : testSurfaces::screws())
        {
            list.emplace_back("screw " + s.name, s.wall);
        }

        const wallSurface screw(testSurfaces::screw(point(3, 4, 5)));

        list.emplace_back("triangles", testSurfaces::triangulated(screw));
        list.emplace_back("blade", testSurfaces::bladeOnEdge(0.1));
        list.emplace_back("thin blade", testSurfaces::bladeOnEdge(1e-3));
        list.emplace_back("corners", testSurfaces::cube(3), 40);
        list.emplace_back("edges", testSurfaces::cube(3), 45.1);
        list.emplace_back("quad corners", testSurfaces::quadCube(3), 40);
        list.emplace_back("quad edges", testSurfaces::quadCube(3), 45.1);
        list.emplace_back("screw's edges", screw, 45.1);
    }

    return list;
}


//- Front faces with n points that are not on the wall
static label nFurtherFaces(const dividedWall& w, const label n)
{
    label count = 0;

    for (label i = w.front.nWallFaces; i < w.front.surface.faces.size(); ++i)
    {
        count += w.front.surface.faces[i].size() == n;
    }

    return count;
}


//- The same of which all points are columns on one point
static label nPointFaces(const dividedWall& w)
{
    label count = 0;

    for (label i = w.front.nWallFaces; i < w.front.surface.faces.size(); ++i)
    {
        const labelList f(w.onWall(i));
        count += f[0] == f[1] && f[1] == f[2];
    }

    return count;
}


//- Columns on each point of the wall
static labelList columnsPerPoint(const dividedWall& w)
{
    labelList counts(w.wall.points.size(), 0);

    for (const label p : w.front.wallPoints)
    {
        ++counts[p];
    }

    return counts;
}


//- How many sides of the cube [0, 1]^3 a point is on
static label nSides(const point& x)
{
    label n = 0;

    for (const scalar c : x)
    {
        n += c < 1e-9 || c > 1 - 1e-9;
    }

    return n;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(layerFront, isDivided)
{
    for (const dividedWall& w : walls())
    {
        EXPECT_GE(w.nExtraColumns(), 1) << w.name;
    }
}


TEST(layerFront, isClosedAndManifold)
{
    for (const dividedWall& w : walls())
    {
        EXPECT_TRUE(testSurfaces::isClosed(w.front.surface)) << w.name;
    }
}


TEST(layerFront, hasTheTopologyOfTheWall)
{
    for (const dividedWall& w : walls())
    {
        EXPECT_EQ
        (
            testSurfaces::eulerCharacteristic(w.front.surface),
            testSurfaces::eulerCharacteristic(w.wall)
        )   << w.name;
    }
}


TEST(layerFront, facesOfTheWallStayWhereTheyWere)
{
    for (const dividedWall& w : walls())
    {
        ASSERT_EQ(w.front.nWallFaces, w.wall.faces.size()) << w.name;
        forAll(w.wall.faces, i)
        {
            EXPECT_EQ(w.onWall(i), w.wall.faces[i])
                << w.name;
            EXPECT_EQ(w.front.surface.patchIDs[i], w.wall.patchIDs[i])
                << w.name;
        }
    }
}


TEST(layerFront, furtherFacesHaveNoPatch)
{
    for (const dividedWall& w : walls())
    {
        const labelList& patchIDs = w.front.surface.patchIDs;

        ASSERT_EQ(patchIDs.size(), w.front.surface.faces.size()) << w.name;
        for (label i = w.front.nWallFaces; i < patchIDs.size(); ++i)
        {
            EXPECT_EQ(patchIDs[i], -1) << w.name;
        }
    }
}


TEST(layerFront, furtherFacesHaveNoArea)
{
    for (const dividedWall& w : walls())
    {
        const wallSurface& surface = w.front.surface;

        for (label i = w.front.nWallFaces; i < surface.faces.size(); ++i)
        {
            EXPECT_NEAR(surface.faces[i].mag(surface.points), 0, 1e-14)
                << w.name;
        }
    }
}


TEST(layerFront, hasTwoFacesForEachFurtherColumn)
{
    // As Euler's formula asks; quadrilaterals count for two
    for (const dividedWall& w : walls())
    {
        EXPECT_EQ
        (
            nFurtherFaces(w, 3) + 2*nFurtherFaces(w, 4),
            2*w.nExtraColumns()
        )   << w.name;
    }
}


TEST(layerFront, firstColumnsAreThoseOfTheWall)
{
    for (const dividedWall& w : walls())
    {
        forAll(w.wall.points, p)
        {
            EXPECT_EQ(w.front.wallPoints[p], p) << w.name;
        }
    }
}


TEST(layerFront, columnsStandOnTheirPoints)
{
    for (const dividedWall& w : walls())
    {
        forAll(w.front.wallPoints, c)
        {
            EXPECT_EQ
            (
                w.front.surface.points[c],
                w.wall.points[w.front.wallPoints[c]]
            )   << w.name;
        }
    }
}


TEST(layerFront, extraColumnPointsAreThePointsOfFurtherColumns)
{
    for (const dividedWall& w : walls())
    {
        EXPECT_EQ
        (
            w.front.extraColumnPoints(),
            labelList
            (
                SubList<label>
                (
                    w.front.wallPoints, w.nExtraColumns(),
                    w.wall.points.size()
                )
            )
        )   << w.name;
    }
}


TEST(layerFront, columnsSeeTheirFaces)
{
    for (const dividedWall& w : walls())
    {
        EXPECT_TRUE(w.front.visibility.emptyCones().empty()) << w.name;
    }
}


TEST(layerFront, isTheWallWithoutNarrowCones)
{
    const dividedWall w("cube", testSurfaces::cube(3), 35);

    EXPECT_EQ(w.front.surface.faces, w.wall.faces);
    EXPECT_EQ(w.front.surface.points, w.wall.points);
    EXPECT_EQ(w.front.surface.patchIDs, w.wall.patchIDs);
    EXPECT_EQ(w.front.wallPoints, identity(w.wall.points.size()));
    EXPECT_TRUE(w.front.extraColumnPoints().empty());
}


TEST(layerFront, fortyDegreesDivideTheCornersOfACube)
{
    // The axis of a corner makes 35.3 degrees with its sides
    const dividedWall w("cube", testSurfaces::quadCube(3), 40);
    const labelList counts(columnsPerPoint(w));

    forAll(counts, p)
    {
        EXPECT_EQ(counts[p], nSides(w.wall.points[p]) == 3 ? 3 : 1);
    }
    EXPECT_EQ(nPointFaces(w), 8);
    EXPECT_EQ(nFurtherFaces(w, 3), 8*4);
    EXPECT_EQ(nFurtherFaces(w, 4), 0);
}


TEST(layerFront, diagonalsOnItsSidesDoNotPreventThat)
{
    const dividedWall w("cube", testSurfaces::cube(3), 40);
    const labelList counts(columnsPerPoint(w));

    // Two columns do where one of them leaves on a diagonal
    forAll(counts, p)
    {
        const bool isCorner = nSides(w.wall.points[p]) == 3;

        EXPECT_GE(counts[p], isCorner ? 2 : 1);
        EXPECT_LE(counts[p], isCorner ? 3 : 1);
    }
}


TEST(layerFront, moreThanHalfARightAngleDividesTheEdgesOfACube)
{
    const label n = 3;
    const dividedWall w("cube", testSurfaces::quadCube(n), 45.1);
    const labelList counts(columnsPerPoint(w));

    forAll(counts, p)
    {
        EXPECT_EQ(counts[p], nSides(w.wall.points[p]));
    }
    EXPECT_EQ(nFurtherFaces(w, 3), 8);
    EXPECT_EQ(nFurtherFaces(w, 4), 12*n);
}


TEST(layerFront, namesPointsWithoutDirection)
{
    // The fluid is in no more than rounding between two of the faces
    const vectorField directions
    ({
        {1, 0, 0}, {1e-12, 1, 1}, {0, 1, -2}, {-1e-12, 1, 1}, {-1, 0, 0},
        {0, -1, 0}
    });
    const dividedWall w("crease", testSurfaces::fan(directions));

    EXPECT_EQ(w.front.pointsWithoutDirection, labelList({0, 3}));
    EXPECT_EQ(w.nExtraColumns(), 0);
}


// ************************************************************************* //
