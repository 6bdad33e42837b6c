/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testStages.H"
#include "testSurfaces.H"
#include "tetrahedralize.H"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;
using testSurfaces::stages;

//- A wall and what is around it
struct filledShape
{
    const char* name;
    wallSurface wall;
    backgroundMesh mesh;
};


static filledShape makeShape(const char* name, const wallSurface& wall)
{
    return filledShape{name, wall, stages(wall, 5, 0.15).background()};
}


//- Made once: all tests look at the same meshes
static const List<filledShape>& shapes()
{
    static const wallSurface box(testSurfaces::cube(4));
    static const List<filledShape> list
    ({
        makeShape("cube", box),
        makeShape("quadCube", testSurfaces::quadCube(4)),
        makeShape("sphere", testSurfaces::sphere(8)),
        makeShape("torus", testSurfaces::torus(24, 12, 1, 0.8)),
        makeShape("lBlock", testSurfaces::lBlock(4)),
        makeShape("slit", testSurfaces::slitBlock(8, 0.05)),
        makeShape
        (
            "bodies",
            testSurfaces::merge
            (
                box,
                testSurfaces::translated(box, vector(1.05, 0.1, 0.2))
            )
        ),
        makeShape("inside", testSurfaces::reversed(testSurfaces::sphere(8)))
    });

    return list;
}


//- The labels in ascending order
static std::vector<label> sorted(std::initializer_list<label> labels)
{
    std::vector<label> s(labels);
    std::sort(s.begin(), s.end());

    return s;
}


static faceList trianglesOf(const wallSurface& wall)
{
    labelList triangleFace;

    return wallTriangles(wall, triangleFace);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(backgroundMesh, beginsWithTheWall)
{
    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        EXPECT_EQ(s.mesh.nWallPoints, s.wall.points.size());
        forAll(s.wall.points, p)
        {
            EXPECT_EQ(s.mesh.points[p], s.wall.points[p]);
            EXPECT_FALSE(s.mesh.free[p]);
        }
    }
}


TEST(backgroundMesh, volumesArePositive)
{
    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        ASSERT_FALSE(s.mesh.tets.empty());
        forAll(s.mesh.tets, t)
        {
            EXPECT_GT(s.mesh.tet(t).mag(), 0);
        }
    }
}


TEST(backgroundMesh, everyTetHasAPointOfTheField)
{
    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        for (const tetCell& tet : s.mesh.tets)
        {
            bool between = false;
            for (const label p : tet)
            {
                between = between || s.mesh.onWall(p) || s.mesh.free[p];
            }
            EXPECT_TRUE(between);
        }
    }
}


TEST(backgroundMesh, wallTrianglesAreFacesOfOneTet)
{
    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        std::multiset<std::vector<label>> faces;
        for (const tetCell& t : s.mesh.tets)
        {
            faces.insert(sorted({t[0], t[1], t[2]}));
            faces.insert(sorted({t[0], t[1], t[3]}));
            faces.insert(sorted({t[0], t[2], t[3]}));
            faces.insert(sorted({t[1], t[2], t[3]}));
        }

        for (const face& f : trianglesOf(s.wall))
        {
            EXPECT_EQ(faces.count(sorted({f[0], f[1], f[2]})), 1u);
        }
    }
}


TEST(backgroundMesh, wallTrianglesFaceTheirTets)
{
    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        List<DynamicList<label>> pointTets(s.mesh.nWallPoints);
        forAll(s.mesh.tets, t)
        {
            for (const label p : s.mesh.tets[t])
            {
                if (s.mesh.onWall(p))
                {
                    pointTets[p].append(t);
                }
            }
        }

        for (const face& f : trianglesOf(s.wall))
        {
            for (const label t : pointTets[f[0]])
            {
                const tetCell& tet = s.mesh.tets[t];

                if (tet.find(f[1]) >= 0 && tet.find(f[2]) >= 0)
                {
                    EXPECT_GT
                    (
                        f.areaNormal(s.mesh.points)
                      & (s.mesh.tet(t).centre() - s.mesh.points[f[0]]),
                        0
                    );
                }
            }
        }
    }
}


TEST(backgroundMesh, neighboursShareTheFace)
{
    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        const backgroundMesh& mesh = s.mesh;

        forAll(mesh.tets, t)
        {
            for (label i = 0; i < 4; ++i)
            {
                const label u = mesh.neighbours[t][i];
                if (u < 0)
                {
                    continue;
                }

                for (label j = 0; j < 4; ++j)
                {
                    EXPECT_EQ(mesh.tets[u].find(mesh.tets[t][j]) < 0, j == i);
                }
                EXPECT_GE(mesh.neighbours[u].find(t), 0);
            }
        }
    }
}


TEST(backgroundMesh, facesWithoutNeighbourAreOnOneTet)
{
    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        std::multiset<std::vector<label>> faces;
        label nBoundary = 0;

        forAll(s.mesh.tets, t)
        {
            const tetCell& tet = s.mesh.tets[t];
            for (label i = 0; i < 4; ++i)
            {
                faces.insert
                (
                    sorted
                    ({
                        tet[(i + 1) % 4], tet[(i + 2) % 4], tet[(i + 3) % 4]
                    })
                );
                nBoundary += s.mesh.neighbours[t][i] < 0;
            }
        }

        label nSingle = 0;
        for (const std::vector<label>& f : faces)
        {
            nSingle += faces.count(f) == 1;
            EXPECT_LE(faces.count(f), 2u);
        }
        EXPECT_EQ(nBoundary, nSingle);
    }
}


TEST(backgroundMesh, edgesAreUnique)
{
    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        std::set<std::vector<label>> edges;
        for (const edge& e : s.mesh.edges)
        {
            edges.insert(sorted({e.start(), e.end()}));
        }

        EXPECT_EQ(label(edges.size()), s.mesh.edges.size());
    }
}


TEST(backgroundMesh, tetEdgesAreInOrder)
{
    static const label ends[6][2] =
        {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        forAll(s.mesh.tets, t)
        {
            const tetCell& tet = s.mesh.tets[t];

            for (label k = 0; k < 6; ++k)
            {
                EXPECT_TRUE
                (
                    s.mesh.edges[s.mesh.tetEdges[t][k]]
                 == edge(tet[ends[k][0]], tet[ends[k][1]])
                );
            }
        }
    }
}


TEST(backgroundMesh, wallIsAFullSubcomplex)
{
    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        std::set<std::vector<label>> wallEdges;
        for (const face& f : trianglesOf(s.wall))
        {
            wallEdges.insert(sorted({f[0], f[1]}));
            wallEdges.insert(sorted({f[1], f[2]}));
            wallEdges.insert(sorted({f[2], f[0]}));
        }

        for (const edge& e : s.mesh.edges)
        {
            if (s.mesh.onWall(e.start()) && s.mesh.onWall(e.end()))
            {
                EXPECT_EQ(wallEdges.count(sorted({e.start(), e.end()})), 1u);
            }
        }
    }
}


TEST(backgroundMesh, gapsArePositive)
{
    for (const filledShape& s : shapes())
    {
        SCOPED_TRACE(s.name);
        for (const tetCell& tet : s.mesh.tets)
        {
            for (const label p : tet)
            {
                EXPECT_GT(s.mesh.gaps[p], 0);
            }
        }
    }
}


TEST(fillGaps, removesWhatIsConnectedToNone)
{
    // Two tetrahedra with a common face and one apart
    backgroundMesh mesh;
    mesh.tets = tetCellList
    ({
        tetCell(0, 1, 2, 3), tetCell(4, 3, 2, 1), tetCell(5, 6, 7, 8)
    });
    mesh.gaps = scalarField({2, 0, 0, 3, 0, 0, 0, 0, 0});

    fillGaps(mesh);

    EXPECT_EQ(mesh.gaps, scalarField({2, 3, 3, 3, 3, 0, 0, 0, 0}));
    EXPECT_EQ
    (
        mesh.tets,
        tetCellList({tetCell(0, 1, 2, 3), tetCell(4, 3, 2, 1)})
    );
}


// ************************************************************************* //
