/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeElements.H"

#include <gtest/gtest.h>
#include <sstream>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A prism, with a patch on its lower triangle and another on the others
static elementMesh prism()
{
    elementMesh mesh;
    mesh.points = pointField
    ({
        point(0, 0, 0), point(1, 0, 0), point(0, 1, 0),
        point(0, 0, 0.1), point(1, 0, 0.1), point(0, 1, 0.1)
    });
    mesh.cells.append(elementShape::prism, labelList({0, 1, 2, 3, 4, 5}));
    mesh.cells.endGroup("layers", mesh.zones);
    mesh.faces.append(elementShape::triangle, labelList({0, 2, 1}));
    mesh.faces.endGroup("wall", mesh.patches);
    mesh.faces.endGroup("nothing", mesh.patches);
    mesh.faces.append(elementShape::triangle, labelList({3, 4, 5}));
    mesh.faces.append(elementShape::quadrilateral, labelList({0, 1, 4, 3}));
    mesh.faces.endGroup("rest", mesh.patches);

    return mesh;
}


template<class Writer>
static std::string text(const Writer& writer)
{
    std::ostringstream os;
    writer(prism(), os);

    return os.str();
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(writeElements, su2)
{
    EXPECT_EQ
    (
        text(writeSu2),
        "NDIME= 3\nNELEM= 1\n13 0 2 1 3 5 4 0\nNPOIN= 6\n0 0 0 0\n1 0 0 1\n"
        "0 1 0 2\n0 0 0.10000000000000001 3\n1 0 0.10000000000000001 4\n"
        "0 1 0.10000000000000001 5\nNMARK= 2\nMARKER_TAG= wall\n"
        "MARKER_ELEMS= 1\n5 0 2 1\nMARKER_TAG= rest\nMARKER_ELEMS= 2\n"
        "5 3 4 5\n9 0 1 4 3\n"
    );
}


TEST(writeElements, msh2HasThePhysicalGroupOfEachElement)
{
    const std::string written(text(writeMsh2));

    EXPECT_NE
    (
        written.find("3\n2 1 \"wall\"\n2 2 \"rest\"\n3 3 \"layers\"\n"),
        std::string::npos
    );
    EXPECT_NE
    (
        written.find
        (
            "$Elements\n4\n1 2 2 1 1 1 3 2\n2 2 2 2 2 4 5 6\n"
            "3 3 2 2 2 1 2 5 4\n4 6 2 3 3 1 2 3 4 5 6\n$EndElements\n"
        ),
        std::string::npos
    );
}


TEST(writeElements, msh4HasABlockForEachShapeOfAGroup)
{
    const std::string written(text(writeMsh4));

    EXPECT_NE
    (
        written.find
        (
            "$Entities\n0 0 2 1\n1 0 0 0 1 1 0 1 1 0\n"
            "2 0 0 0 1 1 0.10000000000000001 1 2 0\n"
        ),
        std::string::npos
    );
    EXPECT_NE
    (
        written.find
        (
            "$Elements\n4 4 1 4\n2 1 2 1\n1 1 3 2\n2 2 2 1\n2 4 5 6\n"
            "2 2 3 1\n3 1 2 5 4\n3 3 6 1\n4 1 2 3 4 5 6\n$EndElements\n"
        ),
        std::string::npos
    );
}


TEST(writeElements, vtuHasItsBytesWhereTheOffsetsSay)
{
    const std::string written(text(writeVtu));
    const size_t start = written.find("encoding=\"raw\">\n_") + 17;

    // The array of the types is the last one
    const size_t types = written.find("Name=\"types\"");
    const size_t offset = written.find("offset=\"", types) + 8;
    const size_t at = start + std::stoul(written.substr(offset));

    EXPECT_EQ(written[at], 4);
    EXPECT_EQ(written.substr(at + 8, 4), std::string("\x0d\x05\x05\x09"));
    EXPECT_NE(written.find("119 97 108 108 0\n"), std::string::npos);
}


// ************************************************************************* //
