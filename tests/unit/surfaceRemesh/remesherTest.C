/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remesher.H"
#include "cutSurface.H"
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
    remesher mesher(given, controls, bounds, guarded);
    mesher.remesh();

    return mesher.edited().surface();
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


TEST(remesher, theGuardChangesNothingElse)
{
    const wallSurface ball(sphere(8, 1));
    const wallSurface free(remeshed(ball, false));
    const wallSurface guarded(remeshed(ball, true));

    EXPECT_EQ(free.points, guarded.points);
    EXPECT_EQ(free.faces, guarded.faces);
}


// ************************************************************************* //
