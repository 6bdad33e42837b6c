/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshSurface.H"
#include "testSurfaces.H"
#include "thrownMessage.H"
#include "wallDefects.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A remesher makes no edges that are longer than what is wanted by more
static const scalar longest = 1.5;

static const scalar maxEdge = 0.2;


static surfaceRemeshControls controlsOf()
{
    surfaceRemeshControls controls;
    controls.maxEdge = maxEdge;
    controls.minEdge = 0.01;
    controls.deviation = 1e-3;

    return controls;
}


//- The longest and the shortest edge of those whose middle fulfils a criterion
template<class Criterion>
static scalarMinMax lengthsOf(const wallSurface& surface, const Criterion& isIn)
{
    scalarMinMax lengths;
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            if (isIn(e.centre(surface.points)))
            {
                lengths += e.mag(surface.points);
            }
        }
    }

    return lengths;
}


static bool isOnTop(const point& x)
{
    return x.z() > 1 - 1e-6;
}


static bool isOnBottom(const point& x)
{
    return x.z() < 1e-6;
}


//- The unit cube, a box of two triangles on each side, with a patch for its top
static wallSurface cubeWithTop()
{
    wallSurface surface(cube(1));
    surface.patchNames = {"wall", "topSide"};
    forAll(surface.faces, facei)
    {
        surface.patchIDs[facei] =
            isOnTop(surface.faces[facei].centre(surface.points));
    }

    return surface;
}


static edgeRegion sphereAt(const std::string& centre, const scalar radius)
{
    edgeRegion region;
    region.name = "nose";
    region.geometry = dictionaryOf
    (
        "type searchableSphere; centre " + centre + "; radius "
      + Foam::name(radius) + ";"
    );
    region.maxEdge = 0.03;

    return region;
}


static wallSurface remeshed
(
    const wallSurface& surface,
    const surfaceRemeshControls& controls
)
{
    const autoPtr<Time> time(Time::New());

    return remeshSurface
    (
        surface, controls, makeSearches(controls.regions, time())
    ).surface;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(edgeBounds, patchesHaveTheirOwn)
{
    surfaceRemeshControls controls(controlsOf());
    controls.patches =
        {{keyType(std::string("top.*"), keyType::REGEX), 0.05}};
    const wallSurface finer(remeshed(cubeWithTop(), controls));

    EXPECT_TRUE(findWallDefects(finer).empty());
    EXPECT_LT(lengthsOf(finer, isOnTop).max(), longest*0.05);
    EXPECT_GT(lengthsOf(finer, isOnBottom).max(), 0.7*maxEdge);

    // Larger than the general one, too
    controls.maxEdge = 0.04;
    controls.patches[0].maxEdge = 0.2;
    const wallSurface coarser(remeshed(cubeWithTop(), controls));
    EXPECT_GT(lengthsOf(coarser, isOnTop).max(), 0.1);
    EXPECT_LT(lengthsOf(coarser, isOnBottom).max(), longest*0.04);
}


TEST(edgeBounds, regionsAreFoundWithinLongEdges)
{
    surfaceRemeshControls controls(controlsOf());
    controls.regions = {sphereAt("(0.3 0.6 1)", 0.1)};
    const wallSurface result(remeshed(cube(1), controls));
    const auto distance = [](const point& x)
    {
        return max(mag(x - point(0.3, 0.6, 1)) - 0.1, scalar(0));
    };

    EXPECT_TRUE(findWallDefects(result).empty());
    EXPECT_GT(lengthsOf(result, isOnBottom).max(), 0.7*maxEdge);
    for (const face& f : result.faces)
    {
        for (const edge& e : f.edges())
        {
            const scalar bound =
                0.03 + (controls.growthRate - 1)*distance
                (
                    e.centre(result.points)
                );
            EXPECT_LT
            (
                e.mag(result.points), longest*min(bound, maxEdge)
            );
        }
    }
}


TEST(edgeBounds, sharpEdgesHaveTheirOwn)
{
    surfaceRemeshControls controls(controlsOf());
    controls.sharpMaxEdge = 0.04;
    controls.sharpAngle = 100;
    const auto isOnSharpEdge = [](const point& x)
    {
        return (mag(x.y() - 0.5) > 0.5 - 1e-6) + (mag(x.z() - 0.5) > 0.5 - 1e-6)
          + (mag(x.x() - 0.5) > 0.5 - 1e-6) > 1;
    };

    // Those of a cube are not sharp enough
    EXPECT_GT
    (
        lengthsOf(remeshed(cube(1), controls), isOnSharpEdge).min(), 0.7*maxEdge
    );

    controls.sharpAngle = 80;
    const wallSurface result(remeshed(cube(1), controls));
    EXPECT_TRUE(findWallDefects(result).empty());
    EXPECT_LT(lengthsOf(result, isOnSharpEdge).max(), longest*0.04);
    EXPECT_GT(lengthsOf(result, [](const point&) { return true; }).max(), 0.08);
}


TEST(edgeBounds, gapsBoundTheEdgesBesideThem)
{
    const scalar gap = 0.02;
    const wallSurface two
    (
        merge(cube(1), translated(cube(1), vector(0, 0, 1 + gap)))
    );
    surfaceRemeshControls controls(controlsOf());
    EXPECT_GT(lengthsOf(remeshed(two, controls), isOnTop).max(), 0.7*maxEdge);

    controls.edgePerGap = 2;
    const wallSurface result(remeshed(two, controls));
    const auto isBesideGap = [&](const point& x)
    {
        return isOnTop(x) && x.z() < 1 + gap + 1e-6;
    };
    EXPECT_TRUE(findWallDefects(result).empty());
    EXPECT_LT(lengthsOf(result, isBesideGap).max(), longest*2*gap);
    EXPECT_GT(lengthsOf(result, isOnBottom).max(), 0.7*maxEdge);
}


TEST(edgeBounds, entriesWithoutAPartAreErrors)
{
    surfaceRemeshControls controls(controlsOf());
    controls.patches = {{keyType("tail"), 0.05}};
    expectWords
    (
        thrownMessage<error>([&]() { remeshed(cubeWithTop(), controls); }),
        {"tail", "surface.remesh.patches", "topSide"}
    );

    controls.patches.clear();
    controls.regions = {sphereAt("(0.3 0.6 0.5)", 0.1)};
    expectWords
    (
        thrownMessage<error>([&]() { remeshed(cube(1), controls); }),
        {"nose", "surface.remesh.regions"}
    );
}


// ************************************************************************* //
