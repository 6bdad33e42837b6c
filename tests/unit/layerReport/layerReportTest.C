/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerReport.H"
#include "prismPolyMesh.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "StringStream.H"

#include <sstream>

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const label n = 4;
static const scalar h1 = 0.01;
static const scalar ratio = 1.25;


//- Six patches: the sides of a cube, named a..f, in layers of exact height
class cubeRun
{
public:

    wallSurface wall;
    layerSpacing spacing;
    prismLayers layers;
    List<squeezeCause> causes;
    List<stageCost> stages;

    cubeRun()
    :
        wall(testSurfaces::cube(4)),
        stages(3)
    {
        wall.patchNames = {"a", "b", "c", "d", "e", "f"};

        const vectorField normals(wall.faceNormals());
        forAll(wall.faces, facei)
        {
            const vector& normal = normals[facei];
            const direction axis =
                mag(normal.x()) > 0.5 ? 0 : mag(normal.y()) > 0.5 ? 1 : 2;

            wall.patchIDs[facei] = 2*axis + (normal[axis] > 0);
        }

        const scalarList heights(testSurfaces::geometricHeights(n, h1, ratio));
        const label nPoints = wall.points.size();

        spacing.nLayers = n;
        spacing.firstThickness = scalarField(nPoints, h1);
        spacing.ratio = scalarField(nPoints, ratio);
        spacing.thickness = scalarField(nPoints, heights.last());
        spacing.layersAsked = labelList(nPoints, n);

        layers = testSurfaces::straightLayers(wall, heights);
        causes.setSize(nPoints, squeezeCause::none);

        stages[0].stage = "read";
        stages[0].seconds = 0.5;
        stages[1].stage = "field";
        stages[1].peakMemory = 123;
        stages[2].stage = "read";
        stages[2].seconds = 0.25;
    }

    layerReport report() const
    {
        layerReport made
        (
            makeLayerReport
            (
                wall, makeWallAddressing(wall).edgeFaces, spacing, layers,
                certify(layers), causes
            )
        );
        made.stages = stages;

        return made;
    }

    //- The point in the middle of side z = 1, and its faces
    label middlePoint(labelList& faces) const
    {
        const label p = wall.points.find(point(0.5, 0.5, 1));

        faces.clear();
        forAll(wall.faces, facei)
        {
            if (wall.faces[facei].found(p))
            {
                faces.append(facei);
            }
        }

        return p;
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(makePercentiles, ofARange)
{
    scalarField values(1001);
    forAll(values, i)
    {
        values[i] = (i*8)%1001;
    }

    const percentiles spread(makePercentiles(values));

    EXPECT_NEAR(spread.mean, 500, 1e-10);
    EXPECT_EQ(spread.min, 0);
    EXPECT_EQ(spread.p1, 10);
    EXPECT_EQ(spread.p5, 50);
    EXPECT_EQ(spread.p50, 500);
    EXPECT_EQ(spread.p95, 950);
    EXPECT_EQ(spread.p99, 990);
    EXPECT_EQ(spread.max, 1000);
}


TEST(makePercentiles, ofOneValue)
{
    scalarField values(1, 3.0);
    const percentiles spread(makePercentiles(values));

    EXPECT_EQ(spread.min, 3);
    EXPECT_EQ(spread.p50, 3);
    EXPECT_EQ(spread.max, 3);
}


TEST(makePercentiles, ofNothing)
{
    scalarField values;

    EXPECT_EQ(makePercentiles(values).max, 0);
}


TEST(makeLayerReport, exactOnFlatParts)
{
    const layerReport report(cubeRun().report());

    ASSERT_EQ(report.patches.size(), 6);

    for (const patchReport& patch : report.patches)
    {
        // Away from its edges, half of the faces of a side
        EXPECT_NEAR(patch.firstHeight.p50, 1, 1e-9);
        EXPECT_NEAR(patch.totalThickness.p50, 1, 1e-9);
        EXPECT_NEAR(patch.growth.p50, 1, 1e-9);
    }
}


TEST(makeLayerReport, sizes)
{
    const layerReport report(cubeRun().report());

    EXPECT_EQ(report.nWallFaces, 12*16);
    EXPECT_EQ(report.nWallPoints, 6*16 + 2);
    EXPECT_EQ(report.nCells, 12*16*n);
    EXPECT_EQ(report.wall.nFaces, 12*16);
    EXPECT_NEAR(report.wall.area, 6, 1e-13);

    for (const patchReport& patch : report.patches)
    {
        EXPECT_EQ(patch.nFaces, 32);
        EXPECT_NEAR(patch.area, 1, 1e-13);
    }
}


TEST(makeLayerReport, fullCoverage)
{
    const layerReport report(cubeRun().report());

    EXPECT_TRUE(report.outlyingCentres.empty());
    EXPECT_EQ(report.wall.layersAsked, n);
    EXPECT_EQ(report.wall.layersReached, n);
    EXPECT_NEAR(report.wall.fullLayersArea, 100, 1e-10);
    EXPECT_GT(report.wall.worstJacobian, 0.3);
}


TEST(makeLayerReport, squeezedColumns)
{
    cubeRun run;
    labelList faces;
    const label p = run.middlePoint(faces);

    for (label i = 1; i <= n; ++i)
    {
        point& q = run.layers.points[run.layers.pointLabel(p, i)];
        q = 0.5*(run.wall.points[p] + q);
    }
    run.causes[p] = squeezeCause::gap;

    const layerReport report(run.report());
    const patchReport& patch = report.patches[run.wall.patchIDs[faces[0]]];

    EXPECT_EQ(report.columns[int(squeezeCause::gap)], 1);
    EXPECT_EQ(report.columns[int(squeezeCause::none)], 97);
    EXPECT_EQ(report.wall.points[int(squeezeCause::gap)], 1);
    EXPECT_EQ(patch.points[int(squeezeCause::gap)], 1);
    EXPECT_EQ(patch.points[int(squeezeCause::none)], 24);

    // One column of three at half the height; a little less because the upper
    // faces tilt, by up to 0.03 and 0.17 rad
    EXPECT_NEAR(patch.firstHeight.min, 5.0/6, 0.0005);
    EXPECT_NEAR(patch.totalThickness.min, 5.0/6, 0.01);
    EXPECT_LT(patch.fullThicknessArea, 100*(1 - faces.size()/32.0) + 1e-9);
    EXPECT_NEAR(patch.growth.p50, 1, 1e-9);
}


TEST(makeLayerReport, namesOfTheMesh)
{
    cubeRun run;
    run.wall.patchNames[2] = layerOuterName;

    EXPECT_EQ(run.report().patches[2].name, "layerOuter2");
}


TEST(makeLayerReport, patchesWithoutFaces)
{
    cubeRun run;
    run.wall.patchNames.append("none");

    const patchReport patch(run.report().patches[6]);
    EXPECT_EQ(patch.nFaces, 0);
    EXPECT_EQ(patch.area, 0);
    EXPECT_EQ(patch.firstHeight.max, 0);
}


TEST(peakMemory, coversWhatIsUsed)
{
    const scalarField used(20000000, 1.0);

    EXPECT_GE(peakMemory(), used.size()*sizeof(scalar)/1e6);
    EXPECT_LT(peakMemory(), 1e6);
}


TEST(toDictionary, hasEveryPatch)
{
    cubeRun run;
    const dictionary dict(toDictionary(run.report()));

    for (const word& name : run.wall.patchNames)
    {
        const dictionary& patch = dict.subDict("patches").subDict(name);

        EXPECT_EQ(patch.get<label>("faces"), 32);
        EXPECT_EQ(patch.get<label>("layersReached"), n);
        EXPECT_NEAR
        (
            patch.subDict("firstHeightOverRequest").get<scalar>("p50"),
            1,
            1e-6
        );
    }

    EXPECT_EQ(dict.subDict("allPatches").get<label>("faces"), 6*32);
}


TEST(toDictionary, certificateColumnsAndStages)
{
    cubeRun run;
    run.causes[3] = squeezeCause::validity;

    const dictionary dict(toDictionary(run.report()));

    EXPECT_EQ(dict.subDict("wall").get<label>("points"), 98);
    const dictionary& certificate = dict.subDict("certificate");
    EXPECT_TRUE(certificate.get<bool>("valid"));
    EXPECT_EQ(certificate.get<label>("stacksNotPositive"), 0);
    EXPECT_EQ(certificate.get<label>("overlaps"), 0);

    const dictionary& columns = dict.subDict("columns");
    EXPECT_EQ(columns.get<label>("total"), 98);
    EXPECT_EQ(columns.get<label>("fullThickness"), 97);
    EXPECT_EQ(columns.subDict("squeezed").get<label>("validity"), 1);

    const dictionary& stages = dict.subDict("stages");
    EXPECT_EQ(stages.subDict("read").get<scalar>("seconds"), 0.75);
    EXPECT_EQ(stages.subDict("field").get<scalar>("peakMemoryMB"), 123);
}


TEST(toDictionary, hasTheNumbersOfTheCertificate)
{
    // The column in the middle of a side goes through the opposite side
    cubeRun run;
    labelList faces;
    const label p = run.middlePoint(faces);
    for (label i = 1; i <= n; ++i)
    {
        run.layers.points[run.layers.pointLabel(p, i)].z() = -i;
    }
    const layerCertificate expected(certify(run.layers));

    ASSERT_GE(expected.nStacksNotPositive, faces.size());
    ASSERT_GT(expected.nOverlaps, 0);

    const layerReport report(run.report());
    const dictionary dict(toDictionary(report));
    const dictionary& certificate = dict.subDict("certificate");

    EXPECT_FALSE(certificate.get<bool>("valid"));
    EXPECT_EQ
    (
        certificate.get<label>("stacksNotPositive"),
        expected.nStacksNotPositive
    );
    EXPECT_EQ(certificate.get<label>("overlaps"), expected.nOverlaps);

    OStringStream os;
    write(os, report);
    const std::string counts
    (
        "stacks not positive " + std::to_string(expected.nStacksNotPositive)
      + ", overlaps " + std::to_string(expected.nOverlaps)
    );
    EXPECT_NE(os.str().find(counts), std::string::npos) << os.str();
}


TEST(toDictionary, canBeReadBack)
{
    const dictionary dict(toDictionary(cubeRun().report()));

    OStringStream os;
    dict.write(os, false);
    IStringStream is(os.str());

    EXPECT_EQ(dictionary(is).toc(), dict.toc());
}


TEST(writeLayerReport, oneRowForEachPatchAndAll)
{
    OStringStream os;
    write(os, cubeRun().report());

    const std::string text(os.str());
    label nRows = 0;
    std::string::size_type width = 0;

    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line) && !line.empty();)
    {
        width = width ? width : line.size();
        EXPECT_EQ(line.size(), width);
        ++nRows;
    }

    EXPECT_EQ(nRows, 2 + 6 + 1);
    EXPECT_NE(text.find("allPatches"), std::string::npos);
}


TEST(writeLayerReport, saysWhereCentresAreOutside)
{
    cubeRun run;
    layerCertificate certificate(certify(run.layers));
    certificate.outlyingCentres = {7};

    const layerReport report
    (
        makeLayerReport
        (
            run.wall, makeWallAddressing(run.wall).edgeFaces, run.spacing,
            run.layers, certificate, run.causes
        )
    );
    OStringStream os;
    write(os, report);

    ASSERT_EQ(report.outlyingCentres.size(), 1);
    const point centre(run.wall.faces[7].centre(run.wall.points));
    EXPECT_NEAR(mag(report.outlyingCentres[0] - centre), 0, 1e-14);
    EXPECT_NE(os.str().find("is outside of the cell"), std::string::npos);
    EXPECT_EQ
    (
        toDictionary(report).subDict("certificate")
       .get<label>("outlyingCentres"),
        1
    );
}


static point middleOf(const wallSurface& wall, const label facei)
{
    return wall.faces[facei].average(wall.points, wall.points);
}


TEST(makeLayerReport, saysWhereAFaceIsLow)
{
    cubeRun run;
    const auto reportOf = [&]()
    {
        return makeLayerReport
        (
            run.wall, makeWallAddressing(run.wall).edgeFaces, run.spacing,
            run.layers, certify(run.layers), run.causes
        );
    };
    EXPECT_TRUE(reportOf().heightJumps.empty());

    // Neighbours share two of its three columns: they are 4 times as high
    for (const label c : run.wall.faces[7])
    {
        point& x = run.layers.points[run.layers.index(c, 1)];
        x = 0.9*run.layers(c, 0) + 0.1*x;
    }
    const layerReport report(reportOf());
    EXPECT_EQ(report.heightJumps.size(), 3);
    EXPECT_NEAR(report.firstHeightChange.max, 4, 0.01);
    EXPECT_EQ(toDictionary(report).get<label>("firstHeightJumps"), 3);
    EXPECT_NEAR(mag(report.worstFirstHeight - middleOf(run.wall, 7)), 0, 1e-9);
    EXPECT_EQ(report.wall.vanishingArea, 0);
}


TEST(makeLayerReport, sharesOfTheArea)
{
    // Away from the edges of the cube, heights are exact
    cubeRun run;
    const patchReport exact(run.report().wall);
    EXPECT_GT(exact.firstHeightArea, 20);
    EXPECT_NEAR(exact.firstHeightMedian, 1, 0.02);

    // Half of all heights: no face has what was asked for
    for (label c = 0; c < run.layers.nColumns(); ++c)
    {
        for (label i = 1; i <= n; ++i)
        {
            point& x = run.layers.points[run.layers.index(c, i)];
            x = 0.5*(run.layers(c, 0) + x);
        }
    }
    const patchReport half(run.report().wall);
    EXPECT_EQ(half.firstHeightArea, 0);
    EXPECT_EQ(half.thicknessArea, 0);
    EXPECT_NEAR(half.firstHeightMedian, 0.5, 0.02);
    EXPECT_NEAR(half.thicknessMedian, 0.5, 0.05);
}


TEST(makeLayerReport, heightsThatVanish)
{
    cubeRun run;
    const label nFaces = run.wall.faces.size();

    // The second layer on one face is a millionth as high as the first one
    for (const label c : run.wall.faces[7])
    {
        const point first(run.layers(c, 1));
        point& second = run.layers.points[run.layers.index(c, 2)];
        second = first + 1e-6*(second - first);
    }
    const layerReport report(run.report());
    EXPECT_GT(report.wall.vanishingArea, 99.0/nFaces);
    EXPECT_LT(report.wall.vanishingArea, 20*100.0/nFaces);
    EXPECT_NEAR(mag(report.worstGrowth - middleOf(run.wall, 7)), 0, 1e-9);
}


TEST(weightedMedian, countsWeights)
{
    EXPECT_EQ(weightedMedian(scalarField(), scalarField()), 0);
    const scalarField values({3, 1, 2});
    EXPECT_EQ(weightedMedian(values, scalarField(3, 1.0)), 2);
    EXPECT_EQ(weightedMedian(values, scalarField({5, 1, 1})), 3);
    EXPECT_EQ
    (
        weightedMedian(scalarField({-1, 0, 1}), scalarField({3, 1, 1})), -1
    );
}


// ************************************************************************* //
