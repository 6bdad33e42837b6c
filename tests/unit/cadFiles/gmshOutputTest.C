/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gmshOutput.H"
#include "thrownMessage.H"

#include <sstream>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A triangle and a line on three points of four, numbered with a gap
static const std::string mesh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$Nodes\n4\n1 0 0 0\n2 1 0 0\n7 0 1 0.5\n3 0 0 9\n$EndNodes\n"
    "$Elements\n2\n1 1 2 0 5 1 2\n2 2 2 0 12 1 2 7\n$EndElements\n";


static cadTriangles meshOf(const std::string& text)
{
    std::istringstream is(text);

    return readMsh(is);
}


static std::string without(const std::string& part)
{
    std::string text(mesh);
    text.erase(text.find(part), part.size());

    return text;
}


static cadModel modelOf(const std::string& text)
{
    std::istringstream is(text);

    return readCadModel(is);
}


static string errorsOf(const std::string& text)
{
    std::istringstream is(text);

    return errorsIn(is);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(gmshOutput, trianglesHaveTheTagsOfTheirFaces)
{
    const cadTriangles triangles(meshOf(mesh));

    EXPECT_EQ(triangles.points.size(), 4);
    EXPECT_EQ(triangles.faces, faceList({face({0, 1, 2})}));
    EXPECT_EQ(triangles.points[2], point(0, 1, 0.5));
    EXPECT_EQ(triangles.tags, labelList({12}));
}


TEST(gmshOutput, brokenMeshesAreRefused)
{
    const auto errorOf = [](const std::string& text)
    {
        return thrownMessage<Foam::error>([&]() { meshOf(text); });
    };

    expectWords(errorOf(""), {"section"});
    expectWords(errorOf(without("$Elements")), {"section"});
    expectWords(errorOf(without("7 0 1 0.5\n")), {"point"});
    expectWords(errorOf(without(" 1 2 7\n")), {"triangle"});
    expectWords(errorOf(mesh.substr(0, mesh.find("2 2 2"))), {"truncated"});
}


TEST(gmshOutput, modelHasSolidsAndFaces)
{
    const cadModel model
    (
        modelOf
        (
            "loose 3\nsolid Shapes/a part\nbound 1\nbound 2\nsolid \nbound 2\n"
            "face 1\nlabel Shapes/inlet\nface 2\nlabel \n"
        )
    );

    EXPECT_EQ(model.nLoose, 3);
    EXPECT_EQ(model.solidLabels, stringList({"Shapes/a part", ""}));
    EXPECT_EQ(model.facesOfSolid[0], labelList({1, 2}));
    EXPECT_EQ(model.facesOfSolid[1], labelList({2}));
    EXPECT_EQ(model.faces, labelList({1, 2}));
    EXPECT_EQ(model.faceLabels, stringList({"Shapes/inlet", ""}));
    EXPECT_EQ(model.nSolids(), labelList({0, 1, 2}));
}


TEST(gmshOutput, modelOfAnythingElseIsRefused)
{
    for (const char* text : {"hello", "face x", "bound 1", "label a"})
    {
        expectWords
        (
            thrownMessage<Foam::error>([&]() { modelOf(text); }), {text}
        );
    }
}


TEST(gmshOutput, errorsAreTakenFromTheLog)
{
    EXPECT_EQ(errorsOf("Info    : Running\nInfo    : Stopped\n"), "");
    EXPECT_EQ
    (
        errorsOf
        (
            "Info    : a\n\033[31;1m**** ERR StepFile : b ****\033[0m\n"
            "Error   : c\nError   : d\nError   : e\n"
        ),
        "**** ERR StepFile : b ****; Error   : c; Error   : d"
    );
}


TEST(gmshOutput, versionIsTakenFromTheLog)
{
    std::istringstream is("a\nInfo : Running 'gmsh' [Gmsh 4.8.4, 1 node]\n");
    std::istringstream none("a\n");

    EXPECT_EQ(versionIn(is), "4.8.4");
    EXPECT_EQ(versionIn(none), "");
}


// ************************************************************************* //
