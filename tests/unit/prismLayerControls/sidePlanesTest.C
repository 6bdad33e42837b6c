/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "minimalControls.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static List<sidePatch> planesOf(const std::string& entries)
{
    return readControls
    (
        "surface { file a.stl; sidePlanes { " + entries + " } }" + layers
    ).surface.sidePlanes;
}


static std::string errorOfPlanes(const std::string& entries)
{
    return thrownMessage([&]() { planesOf(entries); });
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sidePlanes, areReadInTheirOrder)
{
    const List<sidePatch> planes
    (
        planesOf
        (
            "middle { point (1 2 3); normal (0 -2 0); type symmetryPlane; }"
            "ground { point (0 0 0); normal (0 0 -1); }"
        )
    );

    ASSERT_EQ(planes.size(), 2);
    EXPECT_EQ(planes[0].name, "middle");
    EXPECT_EQ(planes[0].type, "symmetryPlane");
    EXPECT_EQ(planes[0].origin, point(1, 2, 3));
    EXPECT_EQ(planes[0].normal, vector(0, -1, 0));
    EXPECT_TRUE(planes[0].faces.empty());
    EXPECT_EQ(planes[1].name, "ground");
    EXPECT_EQ(planes[1].type, "patch");
}


TEST(sidePlanes, wrongEntriesAreErrors)
{
    expectWords
    (
        errorOfPlanes("middle { point (0 0 0); normal (0 0 0); }"),
        {"side plane middle", "normal that is not zero"}
    );
    expectWords
    (
        errorOfPlanes("\"mid.*\" { point (0 0 0); normal (0 0 1); }"),
        {"mid.*", "must have a name"}
    );
    expectWords(errorOfPlanes("middle { normal (0 0 1); }"), {"point"});
    expectWords(errorOfPlanes("middle { point (0 0 1); }"), {"normal"});
    expectWords
    (
        errorOfPlanes("middle { point (0 0 0); normal (0 0 1); type wedge; }"),
        {"type is wedge", "symmetryPlane"}
    );
    expectWords
    (
        errorOfPlanes("middle { point (0 0 0); normals (0 0 1); }"),
        {"Unknown key normals", "did you mean normal"}
    );
}


TEST(sidePlanes, cyclicOnesHaveAPartnerAndARotation)
{
    const auto cyclic = [](const std::string& entries)
    {
        return readControls
        (
            "surface { file a.stl; sidePlanes { a { point (0 0 0);"
            " normal (0 -1 0); " + entries + " } } }" + layers
        ).surface.sidePlanes[0];
    };

    const sidePatch plane
    (
        cyclic
        (
            "type cyclic; partner b;"
            " rotation { axis (0 0 1); origin (0 0 2); angle 72; }"
        )
    );
    EXPECT_EQ(plane.type, "cyclic");
    EXPECT_EQ(plane.cyclic.partner, "b");
    EXPECT_EQ(plane.cyclic.axis, vector(0, 0, 1));
    EXPECT_EQ(plane.cyclic.origin, point(0, 0, 2));
    EXPECT_EQ(plane.cyclic.angle, 72);

    const auto errorOf = [&](const std::string& entries)
    {
        return thrownMessage([&]() { cyclic(entries); });
    };
    expectWords(errorOf("partner b;"), {"partner", "cyclic", "patch"});
    expectWords
    (
        errorOf("type cyclic; rotation { axis (0 0 1); origin (0 0 0);"
            " angle 9; }"),
        {"rotation", "partner"}
    );
    expectWords
    (
        errorOf("type cyclic; partner b; rotation { axis (0 0 0);"
            " origin (0 0 0); angle 9; }"),
        {"axis"}
    );
    expectWords
    (
        errorOf("type cyclic; partner b; rotation { axis (0 0 1);"
            " origin (0 0 0); }"),
        {"angle"}
    );
}


TEST(sidePlanes, emptyNeedsAMeshWithoutAFarField)
{
    const std::string planes
    (
        "surface { file a.stl;"
        " sidePlanes { front { point (0 0 0); normal (0 0 -1); type empty; } }"
        " }" + layers
    );

    EXPECT_EQ(readControls(planes).surface.sidePlanes[0].type, "empty");
    expectWords
    (
        errorOf(planes + "farField { type tet; }"),
        {"front", "type empty", "One cell", "symmetry"}
    );
}


TEST(sidePlanes, filesAreOneOrSeveral)
{
    const auto files = [](const std::string& entries)
    {
        return readControls("surface { " + entries + " }" + layers)
            .surface.files;
    };
    const auto errorOf = [&](const std::string& entries)
    {
        return thrownMessage([&]() { files(entries); });
    };

    EXPECT_EQ(files("file a.stl;"), fileNameList({"a.stl"}));
    EXPECT_EQ
    (
        files("files (a.stl \"b.obj\");"), fileNameList({"a.stl", "b.obj"})
    );
    expectWords
    (
        errorOf("file a.stl; files (b.stl);"), {"file or files, not both"}
    );
    expectWords(errorOf("files ();"), {"files is empty"});
    expectWords(errorOf("file \"\";"), {"file is empty"});
    expectWords(errorOf(""), {"file"});
}


// ************************************************************************* //
