/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldNames.H"
#include "StringStream.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- A wall, an inlet, a side that is symmetric, and an empty side
static const List<namedPatch> somePatches
({
    {"body", "wall", {"wall"}},
    {"inlet", "patch", {"openings"}},
    {"middle", "symmetryPlane", {"symmetryPlane"}},
    {"front", "empty", {"empty"}}
});


static fieldNames compared(const char* boundaryField)
{
    IStringStream is(boundaryField);

    return compareNames(somePatches, dictionary(is));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(compareNames, namesGroupsAndPatterns)
{
    EXPECT_TRUE
    (
        compared("body {} inlet {} middle {}").isComplete()
    );
    EXPECT_TRUE
    (
        compared("wall {} openings {} symmetryPlane {}").isComplete()
    );
    EXPECT_TRUE(compared("\"b.*\" {} \"(inlet|middle)\" {}").isComplete());
    EXPECT_TRUE(compared("\".*\" {}").isComplete());
}


TEST(compareNames, patchesWithoutEntry)
{
    const fieldNames names(compared("body {} \"mid\" {}"));
    EXPECT_EQ(names.patchesWithoutEntry, wordList({"inlet", "middle"}));
    EXPECT_EQ(names.entriesWithoutPatch, wordList({"mid"}));

    // A pattern is for names, not for groups
    EXPECT_EQ
    (
        compared("wall {} middle {} \"open.*\" {}").patchesWithoutEntry,
        wordList({"inlet"})
    );
}


TEST(compareNames, typesOfConstraintsMayMatchNothing)
{
    EXPECT_TRUE
    (
        compared
        (
            "\".*\" {} cyclic {} processor {} wedge {} \"proc.*\" {} value 3;"
        ).isComplete()
    );
}


TEST(compareNames, fieldsWithEqualFindingsShareALine)
{
    fieldNames p(compared("body {} openings {}"));
    fieldNames U(p);
    fieldNames k(compared("\".*\" {}"));
    p.field = "p";
    U.field = "U";
    k.field = "k";
    OStringStream os;
    write(os, List<fieldNames>({U, k, p}));

    EXPECT_EQ
    (
        os.str(), "WARNING: fields U p: no entry for the patches middle\n"
    );
    EXPECT_EQ
    (
        toDictionary(List<fieldNames>({U})).subDict("U")
       .get<wordList>("patchesWithoutEntry"),
        wordList({"middle"})
    );
}


// ************************************************************************* //
