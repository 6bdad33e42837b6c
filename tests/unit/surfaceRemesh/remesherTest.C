/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "edgeBounds.H"
#include "remesher.H"
#include "cutSurface.H"
#include "layerFront.H"
#include "mathematicalConstants.H"
#include "surfaceMeasures.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- New triangles on a surface from which they may be 0.02 m away
static wallSurface remeshed(const wallSurface& surface, const bool guarded)
{
    surfaceRemeshControls controls;
    controls.maxEdge = 0.5;
    controls.minEdge = 0.1;
    controls.deviation = 2e-2;

    const givenSurface given
    (
        surface, controls.featureAngle, controls.deviation
    );
    const PtrList<regionSearch> noRegions;
    const edgeBounds bounds(surface, controls, noRegions);
    editedSurface edited(given, guarded);
    remesher
    (
        edited, [&](editedSurface& made) { bounds.setLengths(made); }
    ).remesh();

    return edited.surface();
}


//- A ring of radius 1 to 2 m. A groove goes round its top: the groove is 0.6 m
//  deep and 0.04 m wide at the top.
static wallSurface groovedRing(const label nSegments)
{
    const List<vector2D> profile
    ({{1, 0}, {2, 0}, {2, 1}, {1.52, 1}, {1.5, 0.4}, {1.48, 1}, {1, 1}});
    const label m = profile.size();
    DynamicList<point> points;
    DynamicList<face> quads;

    for (label i = 0; i < nSegments; ++i)
    {
        const scalar angle = i*constant::mathematical::twoPi/nSegments;
        const label next = (i + 1) % nSegments*m;
        for (label k = 0; k < m; ++k)
        {
            const label up = (k + 1) % m;
            points.append
            (
                point
                (
                    profile[k].x()*Foam::cos(angle),
                    profile[k].x()*Foam::sin(angle), profile[k].y()
                )
            );
            quads.append(face({i*m + k, next + k, next + up, i*m + up}));
        }
    }

    wallSurface ring;
    ring.points = points;
    ring.faces = quads;
    ring.patchIDs = labelList(quads.size(), 0);
    ring.patchNames = wordList({"wall"});

    return triangulated(ring);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(remesher, guardedChangesMakeNoIntersections)
{
    // A shell much thinner than the deviation, with coarser edges
    const wallSurface shell
    (
        merge(sphere(16, 1), reversed(sphere(16, 0.995)))
    );
    EXPECT_TRUE(facesInConflict(shell).empty());
    EXPECT_FALSE(facesInConflict(remeshed(shell, false)).empty());

    const wallSurface result(remeshed(shell, true));
    EXPECT_TRUE(facesInConflict(result).empty());
    EXPECT_LT(result.faces.size(), shell.faces.size());
}


TEST(remesher, guardedChangesLeaveNoPointWithoutDirection)
{
    const wallSurface ring(groovedRing(13));
    ASSERT_GT(measuresOf(ring).volume, 0);
    ASSERT_TRUE(pointsWithoutDirection(ring).empty());
    EXPECT_FALSE(pointsWithoutDirection(remeshed(ring, false)).empty());

    const wallSurface result(remeshed(ring, true));
    EXPECT_TRUE(pointsWithoutDirection(result).empty());
    EXPECT_NE(result.faces.size(), ring.faces.size());
}


TEST(remesher, theGuardChangesNothingElse)
{
    const wallSurface ball(sphere(8, 1));
    const wallSurface free(remeshed(ball, false));
    const wallSurface guarded(remeshed(ball, true));

    EXPECT_EQ(free.points, guarded.points);
    EXPECT_EQ(free.faces, guarded.faces);
}


// ************************************************************************* //
