/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceChanges.H"
#include "surfaceMeasures.H"
#include "testSurfaces.H"
#include "wallDefects.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

typedef editedSurface::Vertex Vertex;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- No edge is longer than so many times what its ends want
static constexpr scalar anyRatio = 100;

namespace
{

//- A surface, and its copy that wants edges of 1 m
struct smallSurface
{
    const wallSurface before;
    const givenSurface given;
    editedSurface edited;
    const editedSurface::Mesh& mesh;
    const std::size_t nEdges;

    explicit smallSurface
    (
        const wallSurface& surface,
        const scalar featureAngle = 30,
        const scalar deviation = 1e-3,
        const bool guarded = false
    )
    :
        before(surface),
        given(before, featureAngle, deviation),
        edited(given, guarded),
        mesh(edited.mesh()),
        nEdges(mesh.number_of_edges())
    {
        for (const Vertex v : mesh.vertices())
        {
            edited.lengths[v] = 1;
        }
    }

    //- From a to b
    editedSurface::Halfedge side(const label a, const label b) const
    {
        return mesh.halfedge(Vertex(a), Vertex(b));
    }

    auto between(label a, label b) const { return mesh.edge(side(a, b)); }

    //- If no point has been taken away
    void expectAt(const label p, const point& x) const
    {
        EXPECT_NEAR(mag(mesh.point(Vertex(p)) - x), 0, 1e-15);
    }

    //- Expects so many points, faces and edges of lines more, the same Euler
    //  characteristic and area, and no defect
    void expectMore(label nPoints, label nFaces, label nLines) const
    {
        const wallSurface after(edited.surface());

        EXPECT_EQ(after.points.size() - before.points.size(), nPoints);
        EXPECT_EQ(after.faces.size() - before.faces.size(), nFaces);
        EXPECT_EQ(edited.features().size() - given.lines().size(), nLines);
        EXPECT_EQ(mesh.number_of_edges(), nEdges + nPoints + nFaces);
        EXPECT_TRUE(findWallDefects(after, !isClosed(before)).empty());
        EXPECT_NEAR(measuresOf(after).area, measuresOf(before).area, 1e-14);
    }

    void expectNoChange() const
    {
        EXPECT_EQ(edited.surface().points, before.points);
        EXPECT_EQ(edited.surface().faces, before.faces);
        EXPECT_EQ(edited.nearestFaces(), identity(before.faces.size()));
        EXPECT_EQ(edited.features().size(), given.lines().size());
    }
};

} // End anonymous namespace


static wallSurface wallOf(const List<point>& points, const faceList& faces)
{
    wallSurface surface;
    surface.points = points;
    surface.faces = faces;
    surface.patchIDs = labelList(faces.size(), 0);

    return surface;
}


//- A tetrahedron. Its edge from 0 to 1, 2 m long, is above the one from 2 to 3.
//  It is regular if y = 1 and height = sqrt(2). Its first two faces are a roof,
//  which is flat if the height is 0.
static wallSurface tetSurface(scalar y, scalar height, label nFaces = 4)
{
    faceList faces
    ({
        face({0, 1, 2}), face({1, 0, 3}), face({0, 2, 3}), face({1, 3, 2})
    });
    faces.resize(nFaces);

    return wallOf
    (
        {{-1, 0, 0}, {1, 0, 0}, {0, y, -height}, {0, -y, -height}}, faces
    );
}


//- A bar of n pieces along x, 1 m wide. Its points 4 i to 4 i + 3 are around x;
//  the upper two, at z = 1, are further along x by a shift. Its sides are cut
//  from 4 i + k to the next i and k.
static wallSurface bar(label n, scalar length = 1, scalar shift = 0)
{
    DynamicList<point> points;
    DynamicList<face> quads;
    for (label i = 0; i <= n; ++i)
    {
        for (label k = 0; k < 4; ++k)
        {
            const label next = 4*i + (k + 1) % 4;
            points.append(point(i*length + k/2*shift, k == 1 || k == 2, k/2));
            quads.append(face({4*i + k, next, next + 4, 4*i + k + 4}));
        }
    }
    quads.resize(4*n);
    quads.append(face({0, 3, 2, 1}));
    quads.append(face({4*n, 4*n + 1, 4*n + 2, 4*n + 3}));
    labelList quadOf;

    return wallOf(points, wallTriangles(wallOf(points, quads), quadOf));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfaceChanges, aSplitOfATetrahedronAddsAPointAndTwoFaces)
{
    for (const edge& e : face({0, 1, 2}).edges())
    {
        smallSurface s(tetSurface(1, Foam::sqrt(2.0)));
        ASSERT_TRUE(splitEdge(s.edited, s.between(e.start(), e.end())));
        s.expectMore(1, 2, 1);
        s.expectAt(4, e.centre(s.before.points));
    }
}


TEST(surfaceChanges, aCollapseTakesASplitOfATetrahedronBack)
{
    for (const label end : {0, 1})
    {
        smallSurface s(tetSurface(1, Foam::sqrt(2.0)));
        ASSERT_TRUE(splitEdge(s.edited, s.between(0, 1)));
        EXPECT_TRUE(collapseEdge(s.edited, s.side(4, end), anyRatio));
        s.expectMore(0, 0, 0);
    }
}


TEST(surfaceChanges, noEdgeOfATetrahedronCollapsesOrFlips)
{
    // There are no lines, and the deviation is large
    smallSurface s(tetSurface(0.5, 0.1), 180, 10);
    for (const auto h : s.mesh.halfedges())
    {
        ASSERT_FALSE(collapseEdge(s.edited, h, anyRatio));
        ASSERT_FALSE(flipEdge(s.edited, s.mesh.edge(h)));
    }
    s.expectNoChange();
}


TEST(surfaceChanges, aPointOfATetrahedronDoesNotMoveIntoItsBase)
{
    smallSurface s(tetSurface(1, Foam::sqrt(2.0)), 180, 10);
    for (const Vertex v : s.mesh.vertices())
    {
        EXPECT_FALSE(smoothVertex(s.edited, v));
        EXPECT_FALSE(optimiseVertex(s.edited, v));
    }
    s.expectNoChange();
}


TEST(surfaceChanges, aFlipTurnsTheDiagonalOfTwoTriangles)
{
    smallSurface s(tetSurface(0.5, 0, 2));
    EXPECT_TRUE(flipEdge(s.edited, s.between(0, 1)));
    EXPECT_FALSE(s.side(0, 1).is_valid());
    EXPECT_TRUE(s.side(2, 3).is_valid());
    EXPECT_EQ(s.edited.surface().points, s.before.points);
    s.expectMore(0, 0, 0);
}


TEST(surfaceChanges, aFlipToAnEdgeThatIsThereIsRefused)
{
    // A flat tetrahedron: the lower two triangles have the other diagonal
    smallSurface s(tetSurface(0.5, 0));
    ASSERT_FALSE(flipEdge(s.edited, s.between(0, 1)));
    s.expectNoChange();
}


TEST(surfaceChanges, aFlipThatMakesNoAngleLargerIsRefused)
{
    // The diagonals of a square
    smallSurface s(tetSurface(1, 0, 2));
    EXPECT_FALSE(flipEdge(s.edited, s.between(0, 1)));
    s.expectNoChange();
}


TEST(surfaceChanges, aFlipStaysWithinTheDeviation)
{
    // The new edge is below the ridge of a roof: so far from its two planes
    const scalar distance = 0.04*Foam::cos(Foam::atan(0.04/0.5));
    smallSurface near(tetSurface(0.5, 0.04, 2), 30, 0.99*distance);
    smallSurface far(tetSurface(0.5, 0.04, 2), 30, 1.01*distance);
    EXPECT_FALSE(flipEdge(near.edited, near.between(0, 1)));
    near.expectNoChange();
    EXPECT_TRUE(flipEdge(far.edited, far.between(0, 1)));
}


TEST(surfaceChanges, aFeatureIsNotFlipped)
{
    // There are 9.1 degrees between the two triangles
    smallSurface feature(tetSurface(0.5, 0.04, 2), 9, 1);
    smallSurface smooth(tetSurface(0.5, 0.04, 2), 10, 1);
    EXPECT_FALSE(flipEdge(feature.edited, feature.between(0, 1)));
    feature.expectNoChange();
    EXPECT_TRUE(flipEdge(smooth.edited, smooth.between(0, 1)));
}


TEST(surfaceChanges, aSplitOfABorderAddsAPointAndAFace)
{
    smallSurface s(tetSurface(1.6, 0, 2));
    ASSERT_TRUE(splitEdge(s.edited, s.between(1, 2)));
    s.expectMore(1, 1, 1);
    s.expectAt(4, point(0.5, 0.8, 0));
}


TEST(surfaceChanges, aSplitThatMakesNoShorterEdgesIsRefused)
{
    // The diagonal is as long as the triangles are high
    smallSurface s(tetSurface(2, 0, 2));
    EXPECT_FALSE(splitEdge(s.edited, s.between(0, 1)));
    s.expectNoChange();
}


TEST(surfaceChanges, aCollapseOnAStraightBorderTakesAFaceAway)
{
    const List<point> points({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const faceList faces({face({0, 1, 3}), face({1, 2, 3})});
    for (const label end : {0, 2})
    {
        smallSurface s(wallOf(points, faces));
        EXPECT_TRUE(collapseEdge(s.edited, s.side(1, end), anyRatio));
        s.expectMore(-1, -1, -1);
    }
}


TEST(surfaceChanges, aCornerDoesNotCollapse)
{
    // The border turns by 53 degrees at the point 2
    smallSurface corner(tetSurface(0.5, 0, 2), 50, 1);
    smallSurface round(tetSurface(0.5, 0, 2), 60, 1);
    EXPECT_FALSE(collapseEdge(corner.edited, corner.side(2, 0), anyRatio));
    corner.expectNoChange();
    EXPECT_TRUE(collapseEdge(round.edited, round.side(2, 0), anyRatio));
}


TEST(surfaceChanges, aGuardedCollapseLeavesAFace)
{
    // The point 2 has one face
    smallSurface guarded(tetSurface(0.5, 0, 2), 60, 1, true);
    EXPECT_FALSE(collapseEdge(guarded.edited, guarded.side(2, 0), anyRatio));
    guarded.expectNoChange();
}


TEST(surfaceChanges, aCollapseToAnEdgeThatIsThereIsRefused)
{
    // Two flat pentagons on each other, nearly straight at the point 1. One has
    // an edge from 1 to 3, the other from 0 to 3.
    const List<point> points
    ({{0, 0, 0}, {1, -0.1, 0}, {2, 0, 0}, {1.5, 1, 0}, {0.5, 1, 0}});
    faceList faces
    ({
        face({0, 1, 4}), face({1, 3, 4}), face({1, 2, 3}),
        face({0, 4, 3}), face({0, 3, 2}), face({0, 2, 1})
    });
    smallSurface both(wallOf(points, faces), 30, 1);
    ASSERT_FALSE(collapseEdge(both.edited, both.side(1, 0), anyRatio));
    both.expectNoChange();

    faces.resize(3);
    smallSurface upper(wallOf(points, faces), 30, 1);
    EXPECT_TRUE(collapseEdge(upper.edited, upper.side(1, 0), anyRatio));
}


TEST(surfaceChanges, aPointMovesToTheMeanOfItsNeighbours)
{
    wallSurface kite(tetSurface(0.6, 0, 2));
    kite.points[3] = point(0.2, -1, 0);
    smallSurface s(kite);
    ASSERT_TRUE(splitEdge(s.edited, s.between(0, 1)));
    EXPECT_TRUE(smoothVertex(s.edited, Vertex(4)));
    s.expectAt(4, point(0.05, -0.1, 0));
    s.expectMore(1, 2, 0);
}


TEST(surfaceChanges, aSplitOfABarAddsAPointAndTwoFaces)
{
    // The diagonal of a side
    smallSurface s(bar(3));
    ASSERT_TRUE(splitEdge(s.edited, s.between(5, 10)));
    s.expectMore(1, 2, 0);
    s.expectAt(16, point(1.5, 1, 0.5));
}


TEST(surfaceChanges, aCollapseAlongABarTakesAPointAndTwoFacesAway)
{
    for (const label end : {0, 8})
    {
        smallSurface s(bar(2));
        EXPECT_TRUE(collapseEdge(s.edited, s.side(4, end), anyRatio));
        s.expectMore(-1, -2, -1);
        EXPECT_FALSE(s.edited.surface().points.found(s.before.points[4]));
    }
}


TEST(surfaceChanges, aCollapseMakesNoEdgeTooLong)
{
    // The longest new edge is the diagonal of two squares
    smallSurface s(bar(2));
    ASSERT_FALSE(collapseEdge(s.edited, s.side(4, 0), 0.99*Foam::sqrt(5.0)));
    s.expectNoChange();
    EXPECT_TRUE(collapseEdge(s.edited, s.side(4, 0), 1.01*Foam::sqrt(5.0)));
}


TEST(surfaceChanges, aCollapseMakesNoSmallAngles)
{
    // Angles of 11 degrees would be halved
    smallSurface s(bar(2, 5));
    EXPECT_FALSE(collapseEdge(s.edited, s.side(4, 0), anyRatio));
    s.expectNoChange();
}


TEST(surfaceChanges, aFlipTurnsTheLongDiagonalOfALeaningBar)
{
    smallSurface s(bar(3, 1, 0.5));
    EXPECT_TRUE(flipEdge(s.edited, s.between(5, 10)));
    EXPECT_FALSE(s.side(5, 10).is_valid());
    EXPECT_TRUE(s.side(6, 9).is_valid());
    s.expectMore(0, 0, 0);
}


TEST(surfaceChanges, aPointOfALineMovesToTheMeanOnTheLine)
{
    wallSurface uneven(bar(2, 1, 0.3));
    uneven.points[4].x() = 1.3;
    smallSurface s(uneven);
    EXPECT_TRUE(smoothVertex(s.edited, Vertex(4)));
    s.expectAt(4, point(1, 0, 0));
    s.expectMore(0, 0, 0);
}


TEST(surfaceChanges, anOptimisedPointHasLargerAngles)
{
    wallSurface uneven(bar(2));
    uneven.points[4].x() = 1.6;
    const scalar before = measuresOf(uneven).smallestAngle;
    smallSurface s(uneven);
    EXPECT_TRUE(optimiseVertex(s.edited, Vertex(4)));
    EXPECT_GT(measuresOf(s.edited.surface()).smallestAngle, before);
    s.expectMore(0, 0, 0);
}


// ************************************************************************* //
