/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "changedPart.H"

#include "testFarField.H"
#include "testLayers.H"
#include "testStages.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Layers and far field around a cube
struct layersInBox
{
    const prismLayerMesh run;
    const farFieldMesh far;
    const farTets tets;

    explicit layersInBox(const farFieldType type)
    :
        run(layeredMesh(cube(3), 4, 0.1)),
        far(farFieldOf(run, controls(type))),
        tets(far, nTetsOf(far))
    {}

    static farFieldControls controls(const farFieldType type)
    {
        farFieldControls controls;
        controls.type = type;
        controls.forPolygons = true;
        controls.boundary.type = farBoundaryType::box;
        controls.boundary.box =
            boundBox(point::uniform(-4), point::uniform(4));

        return controls;
    }

    //- The part around the corners of a front face and of a tetrahedron
    changedPart around(const label facei, const label t) const
    {
        bitSet faces(run.made.layers.faces.size()), changed(tets.size());
        faces.set(facei);
        changed.set(t);

        return changedPart(run.made.layers, far, tets, faces, changed);
    }

    //- The points of each front face and of each cell of the far field
    List<labelList> all() const
    {
        List<labelHashSet> points(far.nCells);
        const polyMeshTopology& t = far.topology;
        forAll(t.faces, facei)
        {
            points[t.owner[facei]].insert(t.faces[facei]);
            if (facei < t.neighbour.size())
            {
                points[t.neighbour[facei]].insert(t.faces[facei]);
            }
        }
        List<labelList> all;
        for (const labelHashSet& of : points)
        {
            all.append(of.sortedToc());
        }
        for (const face& f : run.made.layers.faces)
        {
            all.append(f);
        }

        return all;
    }
};


static void expectRing
(
    const List<labelList>& all,
    const bitSet& inner,
    const bitSet& outer
)
{
    EXPECT_GT(outer.count(), inner.count());
    for (const labelList& points : all)
    {
        const auto isIn = [&](const bitSet& some, const label p)
        {
            return some.test(p);
        };
        bool touches = false, isInside = true;
        for (const label p : points)
        {
            touches = touches || isIn(inner, p);
            isInside = isInside && isIn(outer, p);
        }
        EXPECT_TRUE(!touches || isInside);
    }
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(changedPart, isAllOfTheMeshWithoutChanges)
{
    EXPECT_TRUE(changedPart().isAll());

    const layersInBox mesh(farFieldType::tet);
    const bitSet none;
    EXPECT_TRUE
    (
        changedPart
        (
            mesh.run.made.layers, mesh.far, mesh.tets, none, none
        ).isAll()
    );
}


TEST(changedPart, hasRingsOfAllFrontFacesAndCells)
{
    for (const farFieldType type : {farFieldType::tet, farFieldType::hexCore})
    {
        const layersInBox mesh(type);
        const changedPart part(mesh.around(3, 7));
        EXPECT_FALSE(part.isAll());
        for (const label c : mesh.run.made.layers.faces[3])
        {
            EXPECT_TRUE(part.first.hasPoint(c));
        }
        for (const label p : mesh.tets.points(7))
        {
            EXPECT_TRUE(part.first.hasPoint(p));
        }
        const List<labelList> all(mesh.all());
        expectRing(all, part.first.points, part.second.points);
        expectRing(all, part.second.points, part.third.points);
        for (label celli = 0; celli < mesh.far.nCells; ++celli)
        {
            bool touches = false;
            for (const label p : all[celli])
            {
                touches = touches || part.third.hasPoint(p);
            }
            EXPECT_EQ(part.third.hasFarCell(celli), touches);
        }
    }
}


TEST(changedBetween, findsNewPartsAndWholeOnes)
{
    groupExceptions before;
    const List<vector> places({Zero, vector(1, 0, 0)});
    before.divide(labelList({0, 4}), places, {});
    groupExceptions now(before);
    now.divide(labelList({9, 12}), places, {});
    now.whole.set(5);
    const bitSet changed
    (
        changedBetween
        (
            before, now, 6, [](const label corner) { return corner/4; }
        )
    );
    EXPECT_EQ(changed.toc(), labelList({2, 3, 5}));
}


// ************************************************************************* //
