/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stayingCells.H"
#include "makeHexCore.H"
#include "meshBuilder.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A mesh of cells given by their faces, normals outwards, its boundary in the
//  patch low
static polyMeshParts meshOf
(
    const pointField& points,
    const List<faceList>& cells
)
{
    polyMeshParts made;
    made.points = points;
    made.nCells = cells.size();
    made.patches.append("low", "patch");
    meshBuilder built;

    forAll(cells, celli)
    {
        for (const face& f : cells[celli])
        {
            label beyond = meshBuilder::onPatch(0);
            forAll(cells, other)
            {
                for (const face& g : cells[other])
                {
                    const bool same = face::compare(f, g) < 0;
                    beyond = same ? other : beyond;
                }
            }

            if (beyond < 0 || beyond > celli)
            {
                built.append(f, celli, beyond);
            }
        }
    }
    made.topology = built.topology(built.order(cells.size(), 1), 1);

    return made;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(stayingCells, cellsThatTouchAPlaneInAnEdgeGo)
{
    // A box above the plane z = 0, cut from its edge on x = z = 0 into a prism
    // and a lower cell with a face in the plane. The latter goes. A cube is
    // above the prism, or beside its edge.
    const pointField points
    ({
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
        {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1},
        {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2},
        {-1, 0, 0}, {-1, 1, 0}, {-1, 0, 1}, {-1, 1, 1},
        {1.4, 0, 0}, {1.4, 1, 0}, {1.4, 0, 1}, {1.4, 1, 1}
    });
    const faceList lower
    ({
        face({0, 3, 17, 16}), face({16, 17, 19, 18}), face({5, 18, 19, 6}),
        face({0, 5, 6, 3}), face({0, 16, 18, 5}), face({3, 6, 19, 17})
    });
    const faceList upper
    ({
        face({0, 3, 6, 5}), face({0, 4, 7, 3}), face({4, 5, 6, 7}),
        face({0, 5, 4}), face({3, 7, 6})
    });
    const faceList above
    ({
        face({4, 7, 6, 5}), face({8, 9, 10, 11}), face({4, 5, 9, 8}),
        face({5, 6, 10, 9}), face({6, 7, 11, 10}), face({7, 4, 8, 11})
    });
    const faceList beside
    ({
        face({0, 3, 7, 4}), face({12, 14, 15, 13}), face({0, 12, 13, 3}),
        face({4, 7, 15, 14}), face({0, 4, 14, 12}), face({3, 13, 15, 7})
    });

    const wallSearch search
    (
        testSurfaces::translated
        (
            testSurfaces::cube(1, 0.1), vector(1.2, 0.45, 0.01)
        )
    );
    List<sidePatch> planes(1);
    planes[0].normal = vector(0, 0, -1);
    const auto prismStays = [&](const faceList& third)
    {
        const polyMeshParts mesh(meshOf(points, {lower, upper, third}));
        const coreObstacles obstacles{search, search};
        const stayingCells stays(mesh, obstacles, 0, planes);
        EXPECT_FALSE(stays[0]);
        EXPECT_TRUE(stays[2]);

        return stays[1];
    };

    EXPECT_FALSE(prismStays(above));
    EXPECT_TRUE(prismStays(beside));
}


TEST(stayingCells, smallCellsLeaveRoomAtLongEdges)
{
    // Cells of 1/8 beside edges of sqrt(2): the gap is half of sqrt(2)/2
    const wallSearch search
    (
        testSurfaces::translated
        (
            testSurfaces::cube(1), vector::uniform(-0.5)
        )
    );
    hexCoreBox box;
    box.box = boundBox(point::uniform(-2), point::uniform(2));
    box.patches.append("around", "patch");
    box.sidePatches = labelList(6, Zero);
    const coreObstacles obstacles{search, search};
    const polyMeshParts mesh
    (
        makeHexCore
        (
            box, obstacles, [](const point&) { return 0.125/1.2; }, 1000000
        )
    );
    const stayingCells stays(mesh, obstacles, 0.5, {});
    scalar nearest = GREAT;
    for (label celli = 0; celli < mesh.nCells; ++celli)
    {
        if (stays[celli])
        {
            const boundBox& b = stays.box(celli);
            const vector away(max(b.min(), -b.max()) - vector::uniform(0.5));
            nearest = min(nearest, cmptMax(away));
        }
    }
    EXPECT_GT(nearest, 0.5*std::sqrt(0.5));
    EXPECT_LT(nearest, 0.5*std::sqrt(0.5) + 0.126);
}


// ************************************************************************* //
