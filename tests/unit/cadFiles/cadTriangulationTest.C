/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadTriangulation.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Two tetrahedra on either side of the face with the tag 1
struct twoSolids
{
    cadModel model;
    cadTriangles mesh;

    twoSolids()
    {
        model.solidLabels = stringList({"Shapes/a", "Shapes/b"});
        model.facesOfSolid =
            labelListList({labelList({1, 2, 3, 4}), labelList({1, 5, 6, 7})});
        model.faces = identity(7, 1);
        model.faceLabels = stringList(7);

        mesh.points = pointField
        ({
            point(0, 0, 0), point(1, 0, 0), point(0, 2, 0),
            point(0, 0, 3), point(0, 0, -1)
        });
        mesh.faces = faceList
        ({
            face({0, 1, 2}),
            face({0, 1, 3}), face({1, 2, 3}), face({2, 0, 3}),
            face({0, 1, 4}), face({1, 2, 4}), face({2, 0, 4})
        });
        mesh.tags = identity(7, 1);
    }

    cadTriangulation make() const { return makeCadTriangulation(model, mesh); }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cadTriangulation, theFaceBetweenTwoSolidsIsNotOnTheWall)
{
    const cadTriangulation made(twoSolids().make());

    EXPECT_EQ(made.nBetween, 1);
    EXPECT_EQ(made.nFaults(), 0);
    EXPECT_EQ(made.wall.faces.size(), 6);
    EXPECT_EQ(made.wall.patchIDs, labelList({1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(made.wall.patchNames[4], "b.face2");
}


TEST(cadTriangulation, faultsAreCounted)
{
    twoSolids solids;
    solids.mesh.faces.append(face({3, 1, 0}));
    solids.mesh.tags.append(2);
    EXPECT_EQ(solids.make().nTwins, 1);

    solids = twoSolids();
    solids.mesh.faces.resize(6);
    solids.mesh.tags.resize(6);
    EXPECT_EQ(solids.make().nBare, 1);
    EXPECT_EQ(solids.make().nOpen, 3);
}


TEST(cadTriangulation, facesOfNoSolidMayBeOpen)
{
    twoSolids solids;
    solids.model.solidLabels.clear();
    solids.model.facesOfSolid.clear();
    solids.mesh.faces.resize(6);
    solids.mesh.tags.resize(6);
    const cadTriangulation made(solids.make());

    EXPECT_EQ(made.nOpen, 0);
    EXPECT_EQ(made.nBetween, 0);
    EXPECT_EQ(made.wall.faces.size(), 6);
}


TEST(cadTriangulation, descriptionSaysWhatWasFound)
{
    twoSolids solids;
    solids.model.nLoose = 8;
    const std::string text
    (
        describe(solids.make(), "millimetre", 2, "4.8.4, algorithm 6")
    );

    for
    (
        const char* part :
        {
            "unit: millimetre, scaled", "2 x 4 x 8 m", "solids 2", "faces 7",
            "triangles 6 by gmsh 4.8.4, algorithm 6", "left out 8",
            "between two solids, left out 1"
        }
    )
    {
        EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    }
    EXPECT_EQ(text.find("open"), std::string::npos) << text;
}


// ************************************************************************* //
