/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isolatedProcess.H"
#include "throwingErrors.H"
#include "faceList.H"
#include "pointField.H"
#include "wordList.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Items of all kinds
struct sentItems
{
    label n = 0;
    point x = Zero;
    string text;
    pointField points;
    wordList words;
    faceList faces;
    DynamicList<bool> none;
};


template<class Wire, class Items>
static void visit(Wire& wire, Items& i)
{
    wire(i.n, i.x, i.text, i.points, i.words, i.faces, i.none);
}


static sentItems someItems()
{
    return sentItems
    {
        5, point(1, 2, 3), "two words",
        pointField({point(0, 0, 1), point(0, 0, 2)}), wordList({"a", "", "bc"}),
        faceList({face({0, 1, 2}), face({3, 4, 5, 6})}), DynamicList<bool>()
    };
}


static void expectSame(const sentItems& received)
{
    const sentItems sent(someItems());
    EXPECT_EQ(received.n, sent.n);
    EXPECT_EQ(received.x, sent.x);
    EXPECT_EQ(received.text, sent.text);
    EXPECT_EQ(received.points, sent.points);
    EXPECT_EQ(received.words, sent.words);
    EXPECT_EQ(received.faces, sent.faces);
    EXPECT_TRUE(received.none.empty());
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(message, itemsArriveInTheirOrder)
{
    const sentItems sent(someItems());
    message m;
    visit(m, sent);
    sentItems received;
    messageReader reader(m);
    visit(reader, received);

    expectSame(received);
    EXPECT_TRUE(reader.atEnd());
}


TEST(message, goesThroughAPipeToo)
{
    sentItems received;
    const processEnd end = isolatedProcess
    (
        [](pipeWriter& out) { sentItems sent(someItems()); visit(out, sent); },
        [&](pipeReader& in) { visit(in, received); }
    );

    EXPECT_EQ(end, processEnd::complete);
    expectSame(received);
}


TEST(message, isNotReadBeyondItsEnd)
{
    const throwingErrors throwing;
    message whole;
    const sentItems sent(someItems());
    visit(whole, sent);

    // Also not if the size of a list is all that is there
    for (label n = 0; n < whole.size(); ++n)
    {
        const SubList<char> part(whole, n);
        messageReader reader(part);
        sentItems received;
        EXPECT_THROW(visit(reader, received), Foam::error);
    }

    message wrong;
    wrong(label(-1));
    messageReader reader(wrong);
    EXPECT_THROW(reader.list<point>(), Foam::error);
}


// ************************************************************************* //
