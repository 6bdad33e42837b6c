/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshVerdict.H"
#include "StringStream.H"
#include "throwingErrors.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

typedef verdictLine::grades grades;


//- A patch that has what was asked for: ten layers from 1 mm, 26 mm thick
static patchReport goodPatch(const word& name)
{
    patchReport patch;
    patch.name = name;
    patch.area = 1;
    patch.layersAsked = 10;
    patch.layersReached = 10;
    patch.fullLayersArea = 100;
    patch.firstHeightArea = 100;
    patch.thicknessArea = 100;
    patch.firstHeightMedian = 1;
    patch.thicknessMedian = 1;
    patch.request.firstThickness.add(1e-3);
    patch.request.ratio.add(1.2);
    patch.request.thickness.add(totalThickness(10, 1e-3, 1.2));

    return patch;
}


static layerReport goodReport()
{
    layerReport report;
    report.wall = goodPatch("allPatches");
    report.patches = {goodPatch("body")};

    return report;
}


//- A body in a room that has the given share of the thickness
static layerReport squeezedReport(const scalar room)
{
    layerReport report(goodReport());
    for (patchReport* patch : {&report.wall, &report.patches[0]})
    {
        patch->thicknessArea = 3;
        patch->thicknessMedian = room;
        patch->points[int(squeezeCause::neighbour)] = 50;
        patch->points[int(squeezeCause::gap)] = 20;
    }
    report.worstThickness = point(1, 2, 3);

    return report;
}


static bool hasText(const string& text, const char* part)
{
    return text.find(part) != std::string::npos;
}


static const verdictLine& lineOf(const meshVerdict& verdict, const word& name)
{
    for (const verdictLine& line : verdict.lines)
    {
        if (line.name == name)
        {
            return line;
        }
    }
    static const verdictLine none;
    ADD_FAILURE() << "no line " << name;

    return none;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(meshVerdict, allIsGood)
{
    const layerReport report(goodReport());
    const farFieldReport far;
    const meshVerdict verdict(makeVerdict(&report, &far));

    EXPECT_EQ(verdict.lines.size(), 5);
    EXPECT_FALSE(verdict.isUseless());
    for (const verdictLine& line : verdict.lines)
    {
        EXPECT_EQ(line.grade, grades::good) << line.text;
        EXPECT_TRUE(line.remedy.empty());
    }
    EXPECT_TRUE(hasText(lineOf(verdict, "layers").text, "all 10 on 100 %"));
    EXPECT_FALSE(hasText(lineOf(verdict, "firstHeight").text, "median"));
    EXPECT_EQ(lineOf(verdict, "solver").text, "plain schemes converge");
}


TEST(meshVerdict, saysWhatWouldFit)
{
    const layerReport report(squeezedReport(0.5));
    const meshVerdict verdict(makeVerdict(&report, nullptr));
    const verdictLine& line = lineOf(verdict, "thickness");

    EXPECT_EQ(line.grade, grades::poor);
    EXPECT_EQ(line.place, point(1, 2, 3));
    EXPECT_TRUE(hasText(line.text, "median 0.5 of the request")) << line.text;
    EXPECT_TRUE(hasText(line.text, "opposite wall is too near")) << line.text;
    EXPECT_TRUE(hasText(line.text, "room is 0.013 m, 0.026 m asked"))
        << line.text;

    // 1 mm*(1.2^6 - 1)/0.2 = 9.9 mm, less than 0.9*13 mm; ten layers of at
    // least 1 mm would fit, too
    EXPECT_EQ
    (
        line.remedy,
        "layers.nSurfaceLayers 6 with this first height, or layers.thickness"
        " 0.012"
    );
    EXPECT_EQ(verdict.lines.size(), 4);
}


TEST(meshVerdict, layersThatCannotKeepTheFirstHeight)
{
    // 0.9*5.2 mm: less than ten first heights
    const layerReport report(squeezedReport(0.2));
    const meshVerdict verdict(makeVerdict(&report, nullptr));

    EXPECT_EQ
    (
        lineOf(verdict, "thickness").remedy,
        "layers.nSurfaceLayers 3 with this first height"
    );
}


TEST(meshVerdict, namesTheWorstPatch)
{
    layerReport report(squeezedReport(0.5));
    report.patches = {goodPatch("body"), report.patches[0]};
    report.patches[1].name = "roof";
    const meshVerdict verdict(makeVerdict(&report, nullptr));
    const verdictLine& line = lineOf(verdict, "thickness");

    EXPECT_TRUE(hasText(line.text, "on the patch roof")) << line.text;
    EXPECT_TRUE(hasText(line.remedy, "layers.patches.roof.nSurfaceLayers 6"))
        << line.remedy;
}


TEST(meshVerdict, firstHeightsMissedTenfoldAreUseless)
{
    for (const scalar median : {0.09, 11.0})
    {
        layerReport report(squeezedReport(0.5));
        report.wall.firstHeightMedian = median;
        report.wall.firstHeightArea = 0;
        report.patches[0].firstHeightArea = 0;
        report.worstFirstHeight = point(7, 8, 9);
        const throwingErrors throwing(true);
        try
        {
            requireUsable(report);
            ADD_FAILURE() << "no error for " << median;
        }
        catch (const Foam::error& failure)
        {
            const string message(failure.message());
            EXPECT_TRUE(hasText(message, "(7 8 9)")) << message;
            EXPECT_TRUE(hasText(message, "nSurfaceLayers 6")) << message;
            EXPECT_TRUE(hasText(message, "allowPoorHeights")) << message;
        }
    }
}


TEST(meshVerdict, firstHeightsMissedTwofoldArePoor)
{
    layerReport report(goodReport());
    report.wall.firstHeightMedian = 0.5;
    report.wall.firstHeightArea = 10;
    const meshVerdict verdict(makeVerdict(&report, nullptr));

    EXPECT_EQ(lineOf(verdict, "firstHeight").grade, grades::poor);
    EXPECT_FALSE(verdict.isUseless());
    EXPECT_NO_THROW(requireUsable(report));
}


TEST(meshVerdict, heightsThatVanish)
{
    layerReport report(goodReport());
    report.wall.vanishingArea = 0.5*maxVanishing;
    EXPECT_EQ
    (
        lineOf(makeVerdict(&report, nullptr), "growth").grade, grades::poor
    );
    report.wall.vanishingArea = 2*maxVanishing;
    EXPECT_TRUE(makeVerdict(&report, nullptr).isUseless());
}


TEST(meshVerdict, plainSchemesAreNotTheLastWord)
{
    layerReport report(goodReport());
    farFieldReport far;
    far.grade.factor = 0.95;
    far.grade.place = point(4, 5, 6);
    const meshVerdict diverging(makeVerdict(&report, &far));
    const verdictLine& line = lineOf(diverging, "solver");
    EXPECT_EQ(line.grade, grades::poor);
    EXPECT_EQ(line.place, point(4, 5, 6));
    EXPECT_TRUE(hasText(line.text, "may diverge"));
    EXPECT_TRUE(hasText(line.remedy, "limited corrected 0.5"));

    far.grade.factor = 0;
    report.heightJumps = pointField(2, point(1, 1, 1));
    report.firstHeightChange.max = 5;
    const meshVerdict jumping(makeVerdict(&report, &far));
    EXPECT_TRUE(hasText(lineOf(jumping, "solver").text, "at 2 edges"));
    EXPECT_EQ(lineOf(jumping, "solver").place, point(1, 1, 1));
    EXPECT_EQ
    (
        lineOf(makeVerdict(&report, nullptr), "solver").grade, grades::poor
    );
}


TEST(meshVerdict, logAndReportAreEqual)
{
    const layerReport report(squeezedReport(0.5));
    const meshVerdict verdict(makeVerdict(&report, nullptr));
    OStringStream os;
    write(os, verdict);
    const dictionary dict(toDictionary(verdict));

    EXPECT_EQ
    (
        dict.toc(),
        wordList({"layers", "firstHeight", "thickness", "quality"})
    );
    const dictionary& thickness = dict.subDict("thickness");
    EXPECT_EQ(thickness.get<word>("grade"), "poor");
    EXPECT_EQ(thickness.get<point>("place"), point(1, 2, 3));
    EXPECT_FALSE(dict.subDict("layers").found("remedy"));
    for (const char* key : {"text", "remedy"})
    {
        EXPECT_TRUE
        (
            hasText(os.str(), thickness.get<string>(key).c_str())
        ) << os.str();
    }
    EXPECT_TRUE(hasText(os.str(), "First height")) << os.str();
    EXPECT_TRUE(hasText(os.str(), "Worst at (1 2 3)")) << os.str();
}


TEST(meshVerdict, theWallIsTheFilesOrSomethingIsLost)
{
    wallAccount account;
    account.all.add(areaFate::kept, 3, 0, Zero);
    account.all.add(areaFate::beyond, 1, 0, Zero);
    const verdictLine good(verdictOnWall(account));
    EXPECT_EQ(good.name, "wall");
    EXPECT_EQ(good.grade, grades::good);
    EXPECT_EQ
    (
        good.text,
        "complete: of the files' 4 m2 75 % are in the wall, 25 % were cut off"
        " by sides or lie in sides"
    );

    account.all.add(areaFate::lost, 1, 0.5, point(1, 2, 3));
    const verdictLine poor(verdictOnWall(account));
    EXPECT_EQ(poor.grade, grades::poor);
    EXPECT_EQ(poor.place, point(1, 2, 3));
    EXPECT_NE(poor.text.find("20 % are LOST"), std::string::npos) << poor.text;
}


TEST(meshVerdict, facesBeyondBoundsAreCounted)
{
    layerReport report(goodReport());
    report.faces.nFaces = 1000;
    report.faces.nBeyondAny = 8;
    report.faces.maxNonOrtho = 75;
    EXPECT_EQ(verdictOnQuality(&report, nullptr).grade, grades::good);

    // Those of the far field count, too
    farFieldReport far;
    far.farField = report.faces;
    far.farField.nBeyondAny = 20;
    far.farField.nOfWall = 15;
    far.farField.firstPlace = point(1, 2, 3);
    far.farField.firstLabel = 0;
    const verdictLine line(verdictOnQuality(&report, &far));
    EXPECT_EQ(line.grade, grades::poor);
    EXPECT_NE(line.text.find("28 faces"), std::string::npos) << line.text;
    EXPECT_EQ(line.place, point(1, 2, 3));
    EXPECT_NE(line.remedy.find("remesh"), std::string::npos);
}


// ************************************************************************* //
