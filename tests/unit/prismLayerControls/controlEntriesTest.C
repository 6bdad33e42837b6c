/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "controlEntries.H"
#include "IFstream.H"
#include "thrownMessage.H"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- What reading n within [1, 10] says
template<class Type>
static std::string errorOf(const std::string& text, Type& value)
{
    return thrownMessage
    (
        [&]()
        {
            readBounded(dictionaryOf(text), "n", Type(1), Type(10), value);
        }
    );
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
    EXPECT_FALSE
    (
        readBounded(dictionaryOf("m 2;"), "n", scalar(1), scalar(10), x)
    );
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
        readBounded(dict, "n", scalar(1), scalar(10), x);
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
    const wordList choices({"krylov", "iteration"});
    word value("krylov");

    EXPECT_TRUE(readChoice(dictionaryOf("s iteration;"), "s", choices, value));
    EXPECT_EQ(value, "iteration");

    expectWords
    (
        thrownMessage
        (
            [&]()
            {
                readChoice(dictionaryOf("\n\ns krilov;"), "s", choices, value);
            }
        ),
        {"s is krilov", "did you mean krylov?", "krylov, iteration"}
    );
    EXPECT_EQ(value, "iteration");
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
