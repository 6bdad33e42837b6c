/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refusal.H"
#include "readPrismLayerControls.H"
#include "StringStream.H"
#include "throwingErrors.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- The refusal of an error with this message in a stage
static refusal refused(const char* message, const word& stage)
{
    const throwingErrors throwing(true);
    try
    {
        FatalErrorInFunction << message << exit(FatalError);
    }
    catch (const Foam::error& failure)
    {
        return refusalOf(failure, stage);
    }

    return refusal();
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(refusal, ofAnEntry)
{
    const throwingErrors throwing(true);
    IStringStream is
    (
        "surface { file \"a.stl\"; }\n"
        "layers\n"
        "{\n"
        "    nSurfaceLayers 0; thickness 1;\n"
        "}\n"
    );
    dictionary dict(is);
    dict.name() = "/case/system/harmonicPrismMeshDict";
    dict.subDict("layers").name() = dict.name() + ".layers";
    try
    {
        readPrismLayerControls(dict);
        ADD_FAILURE() << "no error";
    }
    catch (const Foam::error& failure)
    {
        const refusal what(refusalOf(failure, ""));
        EXPECT_EQ(what.code, refusal::codes::dictionary);
        EXPECT_EQ(what.status(), 2);
        EXPECT_EQ(what.entry, "layers.nSurfaceLayers");
        EXPECT_EQ(what.file, "/case/system/harmonicPrismMeshDict");
        // A stream from a string counts its lines from 0
        EXPECT_EQ(what.line, 3);
    }
}


TEST(refusal, ofASurface)
{
    const refusal what
    (
        refused
        (
            "The patch inlet has a hole at (1 -2.5 3e-4).\n"
            "Write surface.repair stitch, or close the hole", "wallDefects"
        )
    );
    EXPECT_EQ(what.code, refusal::codes::surface);
    EXPECT_EQ(what.status(), 3);
    EXPECT_EQ(what.stage, "wallDefects");
    EXPECT_EQ(what.patch, "inlet");
    EXPECT_EQ(what.entry, "surface.repair");
    EXPECT_EQ(what.place, pointField(1, point(1, -2.5, 3e-4)));
    EXPECT_EQ(what.remedy, "Write surface.repair stitch, or close the hole");
}


TEST(refusal, ofOtherKinds)
{
    EXPECT_EQ(refused("No mesh", "").status(), 1);
    EXPECT_EQ(refused("No mesh", "farFieldMesh").status(), 1);
    EXPECT_EQ(refused("Cannot write a", "prismPolyMesh").status(), 5);
    EXPECT_EQ(refused("not enough memory", "wallSurface").status(), 5);
}


TEST(refusal, onlyKnownFields)
{
    const dictionary dict(toDictionary(refused("No mesh", "")));

    EXPECT_EQ
    (
        dict.toc(),
        wordList
        ({
            "schemaVersion", "version", "status", "code", "exitStatus",
            "stage", "message"
        })
    );
    EXPECT_EQ(dict.get<word>("status"), "refused");
    EXPECT_EQ(dict.get<string>("message"), "No mesh");
}


TEST(refusalError, hasItsFields)
{
    refusal what;
    what.code = refusal::codes::noRoom;
    what.message = "No room";
    what.place = pointField(1, point(1, 2, 3));
    try
    {
        throw refusalError(what);
    }
    catch (const Foam::error& failure)
    {
        const refusal known(refusalOf(failure, "prismLayers"));
        EXPECT_EQ(failure.message(), "No room");
        EXPECT_EQ(known.status(), 4);
        EXPECT_EQ(known.place[0], point(1, 2, 3));
        EXPECT_EQ(known.stage, "prismLayers");
    }
}


// ************************************************************************* //
