/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepFaceNames.H"

#include <gtest/gtest.h>

#include <sstream>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static List<stringList> namesOf(const std::string& entities)
{
    std::istringstream is("ISO-10303-21;\nDATA;\n" + entities + "ENDSEC;\n");

    return readStepFaceNames(is);
}


//- A model of solids with so many faces each, whose tags count on from 1
static cadModel stepModelOf(const labelList& nFaces)
{
    cadModel model;
    label tag = 0;

    for (const label n : nFaces)
    {
        model.solidLabels.append("");
        model.facesOfSolid.append(identity(n, tag + 1));
        tag += n;
    }
    model.faces = identity(tag, 1);
    model.faceLabels = stringList(tag, "label");

    return model;
}


static stringList labelsAfter
(
    const List<stringList>& names,
    const labelList& nFaces
)
{
    cadModel model(stepModelOf(nFaces));
    nameFaces(names, model);

    return model.faceLabels;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(stepFaceNames, areInTheOrderOfTheShell)
{
    EXPECT_EQ
    (
        namesOf
        (
            "#1 = MANIFOLD_SOLID_BREP('part',#2);\n"
            "#2 = CLOSED_SHELL('',(#9,#7,\n#8));\n"
            "#7 = ADVANCED_FACE('in; let',(#3),#4,.T.);\n"
            "#8=ADVANCED_FACE('',(#3),#4,.T.);\n"
            "#9 = ADVANCED_FACE('#5',(#3),#4,.F.);\n"
        ),
        List<stringList>({stringList({"#5", "in; let", ""})})
    );
}


TEST(stepFaceNames, ofVoidsFollow)
{
    EXPECT_EQ
    (
        namesOf
        (
            "#1=BREP_WITH_VOIDS('',#2,(#3));"
            "#2=CLOSED_SHELL('',(#7));#3=ORIENTED_CLOSED_SHELL('',*,#4,.F.);"
            "#4=CLOSED_SHELL('',(#8));"
            "#7=ADVANCED_FACE('outer',(),#5,.T.);"
            "#8=FACE_SURFACE('inner',(),#5,.T.);"
        ),
        List<stringList>({stringList({"outer", "inner"})})
    );
}


TEST(stepFaceNames, ofAShellWithoutSolid)
{
    EXPECT_EQ
    (
        namesOf
        (
            "#1=SHELL_BASED_SURFACE_MODEL('',(#2));#2=OPEN_SHELL('',(#7));"
            "#7=ADVANCED_FACE('wall',(),#5,.T.);"
        ),
        List<stringList>({stringList({"wall"})})
    );
}


TEST(stepFaceNames, oneNameOfAllFacesIsNone)
{
    EXPECT_EQ
    (
        namesOf
        (
            "#1=MANIFOLD_SOLID_BREP('',#2);#2=CLOSED_SHELL('',(#7,#8));"
            "#7=ADVANCED_FACE('PartBody',(),#5,.T.);"
            "#8=ADVANCED_FACE('PartBody',(),#5,.T.);"
        ),
        List<stringList>({stringList(2)})
    );
}


TEST(stepFaceNames, goToTheSolidsInTheirOrder)
{
    EXPECT_EQ
    (
        labelsAfter({{"a", ""}, {"b", "c"}}, {2, 2}),
        stringList({"a", "label", "b", "c"})
    );
}


TEST(stepFaceNames, goToEachCopyOfAPart)
{
    EXPECT_EQ
    (
        labelsAfter({{"a", "b"}, {"c"}}, {1, 2, 1}),
        stringList({"c", "a", "b", "c"})
    );
}


TEST(stepFaceNames, staySilentIfPartsCannotBeTold)
{
    EXPECT_EQ
    (
        labelsAfter({{"a", "b"}, {"c", "d"}, {"e"}}, {2, 3, 1}),
        stringList({"label", "label", "label", "label", "label", "e"})
    );
}


TEST(stepFaceNames, ofAShellGoToTheFaces)
{
    cadModel model(stepModelOf({2}));
    model.solidLabels.clear();
    model.facesOfSolid.clear();
    nameFaces({{"a", "b"}}, model);

    EXPECT_EQ(model.faceLabels, stringList({"a", "b"}));
}


// ************************************************************************* //
