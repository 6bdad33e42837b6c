/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadTriangulation.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Solids with two faces each, whose tags count on, and labels
static cadModel modelOf(const stringList& solids, const stringList& faces)
{
    cadModel model;
    model.solidLabels = solids;
    model.faceLabels = faces;
    model.faces = identity(faces.size(), 1);

    forAll(solids, i)
    {
        model.facesOfSolid.append(labelList({2*i + 1, 2*i + 2}));
    }

    return model;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cadPatches, facesOfOneSolidAreNumbered)
{
    const wordList names({"face1", "face2"});

    EXPECT_EQ(cadPatchNames(modelOf({""}, {"", ""})), names);
    EXPECT_EQ(cadPatchNames(modelOf({}, {"", ""})), names);
}


TEST(cadPatches, facesHaveTheirOwnNames)
{
    EXPECT_EQ
    (
        cadPatchNames
        (
            modelOf({"Shapes/Part"}, {"Shapes/Part/inlet", "Shapes/Part"})
        ),
        wordList({"inlet", "face2"})
    );
}


TEST(cadPatches, wordsOfProgramsAreNoNames)
{
    EXPECT_EQ
    (
        cadPatchNames
        (
            modelOf
            (
                {
                    "Shapes/Asm/PLATE/=>[0:1:1:3]/SOLID",
                    "Shapes/1/Open CASCADE STEP translator 7.6 1.3"
                },
                {"Shapes/SOLID", "Shapes/COMPOUND", "", "Shapes/a b"}
            )
        ),
        wordList
        ({
            "PLATE.face1", "PLATE.face2", "solid1.face1", "solid1.ab"
        })
    );
}


TEST(cadPatches, solidsOfOneNameAreNumbered)
{
    EXPECT_EQ
    (
        cadPatchNames
        (
            modelOf
            (
                {"Shapes/nut", "Shapes/rod", "Shapes/nut", ""},
                stringList(8)
            )
        ),
        wordList
        ({
            "nut1.face1", "nut1.face2", "rod.face1", "rod.face2",
            "nut2.face1", "nut2.face2", "solid1.face1", "solid1.face2"
        })
    );
}


// ************************************************************************* //
