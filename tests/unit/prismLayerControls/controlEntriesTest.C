/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "controlEntries.H"
#include "IFstream.H"
#include "labelPair.H"
#include "thrownMessage.H"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Declares n, within [1, 10], and m
template<class Number>
static void declareNumbers(controlEntries& entries, Number& value)
{
    scalar other = 0;
    entries.readBounded("n", value, 1, 10, "A number");
    entries.readBounded("m", other, SMALL, GREAT, "Another", "the first");
}


template<class Number>
static void readNumbers(const dictionary& dict, Number& value)
{
    controlEntries::read(dict, [&](controlEntries& entries)
    {
        declareNumbers(entries, value);
    });
}


template<class Number>
static std::string errorOf(const std::string& text, Number& value)
{
    return thrownMessage([&]() { readNumbers(dictionaryOf(text), value); });
}

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(readBounded, readsWhatIsThere)
{
    scalar x = 5;
    EXPECT_EQ(errorOf("n 2.5;", x), "");
    EXPECT_EQ(x, 2.5);

    label n = 5;
    EXPECT_EQ(errorOf("n 10;", n), "");
    EXPECT_EQ(n, 10);
}


TEST(readBounded, keepsTheDefault)
{
    scalar x = 5;
    readNumbers(dictionaryOf("m 2;"), x);
    EXPECT_EQ(x, 5);
}


TEST(readBounded, namesKeyValueAndBounds)
{
    scalar x = 5;
    expectWords(errorOf("m 1;\nn 10.5;", x), {"n is 10.5", "1 to 10"});
    expectWords(errorOf("n -3;", x), {"n is -3", "1 to 10"});
    EXPECT_EQ(x, 5);
}


TEST(readBounded, namesFileAndLine)
{
    char path[] = "/tmp/controlEntriesXXXXXX";
    const int descriptor = mkstemp(path);
    ASSERT_GE(descriptor, 0);
    close(descriptor);
    std::ofstream(path) << "m 1;\n\nn 11;\n";
    IFstream is(path);
    const dictionary dict(is);
    std::remove(path);

    scalar x = 5;
    try
    {
        readNumbers(dict, x);
        ADD_FAILURE();
    }
    catch (const IOerror& e)
    {
        EXPECT_EQ(e.ioFileName(), path);
        EXPECT_EQ(e.ioStartLineNumber(), 3);
    }
}


TEST(readBounded, refusesWhatIsNotANumber)
{
    scalar x = 5;
    label n = 5;

    for
    (
        const char* text :
        {
            "n nan;", "n inf;", "n 1e999;", "n two;", "n;",
            "n (1 2);", "n 1 2;", "n {}", "n \"2\";"
        }
    )
    {
        EXPECT_NE(errorOf(text, x), "") << text;
        EXPECT_NE(errorOf(text, n), "") << text;
    }

    EXPECT_NE(errorOf("n 2.5;", n), "");
    EXPECT_NE(errorOf("n 99999999999999;", n), "");
    EXPECT_EQ(x, 5);
    EXPECT_EQ(n, 5);
}


TEST(readChoice, namesTheChoices)
{
    word value("krylov");
    bool isSecond = false;
    const auto readAll = [&](const std::string& text)
    {
        controlEntries::read(dictionaryOf(text), [&](controlEntries& entries)
        {
            entries.readChoice("s", value, {"krylov", "iteration"}, "A word");
            entries.readChoice("t", isSecond, {"first", "second"}, "A word");
        });
    };
    readAll("s iteration; t second;");
    EXPECT_EQ(value, "iteration");
    EXPECT_TRUE(isSecond);

    expectWords
    (
        thrownMessage([&]() { readAll("\n\ns krilov;"); }),
        {"s is krilov", "did you mean krylov?", "krylov, iteration"}
    );
    EXPECT_EQ(value, "iteration");
}


TEST(controlEntries, unknownKeysComeFirst)
{
    scalar x = 5;
    expectWords
    (
        errorOf("n 20; k 1;", x), {"Unknown key k", "Valid keys: n, m"}
    );
}


TEST(controlEntries, itemsHaveTheirNames)
{
    List<labelPair> items;
    wordList names;
    controlEntries::read
    (
        dictionaryOf("parts { a { n 2; } b { n 3; } }"),
        [&](controlEntries& entries)
        {
            entries.readDicts
            (
                "parts", items, "Parts",
                [&](controlEntries& part, const keyType& key, labelPair& item)
                {
                    names.append(part.dict() ? wordList(1, key) : wordList());
                    part.readBounded("n", item.first(), 1, 10, "A number");
                    part.require("n");
                }
            );
        }
    );
    EXPECT_EQ(names, wordList({"a", "b"}));
    ASSERT_EQ(items.size(), 2);
    EXPECT_EQ(items[0].first(), 2);
    EXPECT_EQ(items[1].first(), 3);
}


TEST(controlEntries, listHasNamesDefaultsAndRanges)
{
    const List<entryText> all(controlEntries::list([](controlEntries& entries)
    {
        label n = 5;
        entries.readDict("sub", "Some entries", [&](controlEntries& sub)
        {
            declareNumbers(sub, n);
        });
    }));
    ASSERT_EQ(all.size(), 3);
    EXPECT_EQ(all[0].name, "sub");
    EXPECT_EQ(all[1].name, "sub.n");
    EXPECT_EQ(all[1].standard, "5");
    EXPECT_EQ(all[1].range, "[1, 10]");
    EXPECT_EQ(all[1].text, "A number");
    EXPECT_EQ(all[2].standard, "the first");
    EXPECT_EQ(all[2].range, "> 0");
}


TEST(checkKeys, namesUnknownKeyAndValidOnes)
{
    expectWords
    (
        thrownMessage
        (
            [&]()
            {
                checkKeys
                (
                    dictionaryOf("scale 1;\nfulid inside;"),
                    {"scale", "fluid"}
                );
            }
        ),
        {"Unknown key fulid", "did you mean fluid?", "scale, fluid"}
    );
}


TEST(checkKeys, guessesNothingFarFetched)
{
    const std::string message
    (
        thrownMessage
        (
            [&]() { checkKeys(dictionaryOf("xyz 1;"), {"scale", "fluid"}); }
        )
    );

    expectWords(message, {"Unknown key xyz"});
    EXPECT_EQ(message.find("did you mean"), std::string::npos);
}


TEST(checkKeys, patternIsUnknown)
{
    EXPECT_NE
    (
        thrownMessage
        (
            [&]() { checkKeys(dictionaryOf("\"scale\" 1;"), {"scale"}); }
        ),
        ""
    );
}


TEST(checkKeys, headerOfTheFileIsKnown)
{
    EXPECT_EQ
    (
        thrownMessage
        (
            [&]()
            {
                checkKeys(dictionaryOf("FoamFile { version 2; }"), {"a"});
            }
        ),
        ""
    );
}


// ************************************************************************* //
