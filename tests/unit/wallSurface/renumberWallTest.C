/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallChanges.H"
#include "openSurfaces.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using namespace Foam::testSurfaces;

//- Half a sphere that ends on a symmetry plane, of two patches, its points and
//  faces in random order
static wallSurface shuffledHalfSphere()
{
    wallSurface wall(endedOn(renumbered(halfSphere(24), 7), halfPlanes()));
    wall.patchNames = wordList({"left", "right"});
    forAll(wall.faces, facei)
    {
        wall.patchIDs[facei] = wall.faces[facei].centre(wall.points).y() > 0;
    }

    return wall;
}


//- Patches and corners of all faces, sorted
static std::vector<std::vector<scalar>> facesOf(const wallSurface& wall)
{
    std::vector<std::vector<scalar>> all;

    forAll(wall.faces, facei)
    {
        all.push_back({scalar(wall.patchIDs[facei])});
        for (const point& x : wall.faces[facei].points(wall.points))
        {
            all.back().insert(all.back().end(), x.begin(), x.end());
        }
    }
    std::sort(all.begin(), all.end());

    return all;
}


//- Share of edges between points whose labels differ by at most 32
static scalar shareNear(const wallSurface& wall)
{
    const edgeList edges(makeWallAddressing(wall).edges);
    const label nNear = std::count_if
    (
        edges.begin(), edges.end(),
        [](const edge& e) { return mag(e.start() - e.end()) <= 32; }
    );

    return scalar(nNear)/edges.size();
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(renumberWall, facesAndTheirPatchesAreAsTheyWere)
{
    const wallSurface before(shuffledHalfSphere());
    wallSurface wall(before);
    renumberWall(wall);

    EXPECT_NE(wall.faces, before.faces);
    EXPECT_EQ(facesOf(wall), facesOf(before));
}


TEST(renumberWall, theBorderKeepsItsEdgesInTheirOrder)
{
    const wallSurface before(shuffledHalfSphere());
    wallSurface wall(before);
    renumberWall(wall);

    ASSERT_GT(before.border.edges.size(), 0);
    ASSERT_EQ(wall.border.edges.size(), before.border.edges.size());
    forAll(wall.border.edges, i)
    {
        const edge& now = wall.border.edges[i];
        const edge& was = before.border.edges[i];

        EXPECT_EQ(wall.points[now.start()], before.points[was.start()]);
        EXPECT_EQ(wall.points[now.end()], before.points[was.end()]);
    }
}


TEST(renumberWall, neighboursAreNearToEachOther)
{
    wallSurface wall(shuffledHalfSphere());
    EXPECT_LT(shareNear(wall), 0.1);

    renumberWall(wall);
    EXPECT_GT(shareNear(wall), 0.6);
    EXPECT_TRUE
    (
        std::is_sorted
        (
            wall.faces.begin(), wall.faces.end(),
            [](const face& a, const face& b) { return min(a) < min(b); }
        )
    );
}

// ************************************************************************* //
