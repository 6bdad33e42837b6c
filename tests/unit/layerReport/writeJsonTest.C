/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeJson.H"
#include "scalarList.H"
#include "StringStream.H"
#include "Switch.H"
#include "vector.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

using namespace Foam;

TEST(jsonOf, numbersWordsAndTexts)
{
    // Other tests may have set another one
    IOstream::defaultPrecision(6);
    dictionary dict;
    dict.add("cells", label(12));
    dict.add("area", scalar(1.0)/3);
    dict.add("small", scalar(2.5e-7));
    dict.add("valid", Switch(true));
    dict.add("grade", word("poor"));
    dict.add("text", string("a \"b\"\nc\\d"));

    EXPECT_EQ
    (
        jsonOf(dict),
        "{\n"
        "    \"cells\": 12,\n"
        "    \"area\": 0.333333,\n"
        "    \"small\": 2.5e-07,\n"
        "    \"valid\": true,\n"
        "    \"grade\": \"poor\",\n"
        "    \"text\": \"a \\\"b\\\"\\nc\\\\d\"\n"
        "}\n"
    );
}


TEST(jsonOf, lists)
{
    dictionary dict;
    dict.add("place", vector(1, -2, 0.5));
    dict.add("equal", scalarList(3, 7.0));
    dict.add("different", scalarList({1.5, 2, 3}));
    dict.add("many", labelList({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
    dict.add("none", labelList());
    IStringStream is
    (
        "words (a b (1 2)); two 1 2; sized 2 ((1 2) (3 4)); nothing;"
    );
    dict.merge(dictionary(is));

    EXPECT_EQ
    (
        jsonOf(dict),
        "{\n"
        "    \"place\": [1, -2, 0.5],\n"
        "    \"equal\": [7, 7, 7],\n"
        "    \"different\": [1.5, 2, 3],\n"
        "    \"many\": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12],\n"
        "    \"none\": [],\n"
        "    \"words\": [\"a\", \"b\", [1, 2]],\n"
        "    \"two\": [1, 2],\n"
        "    \"sized\": [[1, 2], [3, 4]],\n"
        "    \"nothing\": null\n"
        "}\n"
    );
}


TEST(jsonOf, dictionaries)
{
    dictionary dict;
    dictionary inner;
    inner.add("n", label(1));
    dict.add("patch.1", inner);
    dict.add("empty", dictionary());

    EXPECT_EQ
    (
        jsonOf(dict),
        "{\n"
        "    \"patch.1\": {\n"
        "        \"n\": 1\n"
        "    },\n"
        "    \"empty\": {}\n"
        "}\n"
    );
}


TEST(jsonOf, numbersThatAreNotFinite)
{
    dictionary dict;
    dict.add("x", scalar(std::numeric_limits<scalar>::infinity()));
    dict.add("y", scalar(std::numeric_limits<scalar>::quiet_NaN()));

    EXPECT_EQ(jsonOf(dict), "{\n    \"x\": null,\n    \"y\": null\n}\n");
}


// ************************************************************************* //
