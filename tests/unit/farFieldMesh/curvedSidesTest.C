/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "memoryMesh.H"
#include "layerGeometry.H"
#include "openSurfaces.H"
#include "sideShape.H"
#include "surfaceMeasures.H"
#include "testFarField.H"
#include "testStages.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const label nCurvedLayers = 4;
static const scalar thickness = 0.1;


//- Layers that end on a curved side patch, and the rest of the fluid
struct curvedCase
{
    wallSurface wall;
    scalar volume;
    prismLayerMesh run;
    farFieldMesh far;
    std::unique_ptr<memoryMesh> memory;

    curvedCase(const wallSurface& w, const scalar v)
    :
        wall(w),
        volume(v),
        run(layeredMesh(wall, nCurvedLayers, thickness))
    {
        farFieldControls controls;
        controls.type = farFieldType::tet;
        far = farFieldOf(run, controls);
        memory.reset(new memoryMesh(run.made.layers, far));
    }

    const polyMesh& mesh() const { return (*memory)(); }
};


//- Bulges out of the duct and into it, half of one, and a vessel whose side is
//  a whole cylinder
static const std::vector<std::unique_ptr<curvedCase>>& curvedCases()
{
    static std::vector<std::unique_ptr<curvedCase>> list;

    if (list.empty())
    {
        const auto add = [&](const wallSurface& wall, const scalar volume)
        {
            list.emplace_back(new curvedCase(wall, volume));
        };

        // Of a paraboloid
        const scalar bulge = 0.2 - 0.4/6;
        const wordList sides({"inlet", "outlet"});
        wallSurface inward(bulgedDuct(12));
        for (point& x : inward.points)
        {
            x.x() -= 2*(1 - x.x())/(1 - bulgeAt(x))*bulgeAt(x);
        }

        add(endedOn(bulgedDuct(12), sides), 1 + bulge);
        add(endedOn(inward, sides), 1 - bulge);
        add(halfOf(bulgedDuct(12)), 0.5*(1 + bulge));
        add
        (
            endedOn(vessel(), wordList({"around", "top"})),
            -Foam::enclosedVolume(vessel())
        );
    }

    return list;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(curvedSides, layersAreThickAndFollowAField)
{
    for (const auto& c : curvedCases())
    {
        EXPECT_EQ(c->run.noField, "");
        EXPECT_TRUE(c->run.certificate.valid());
        EXPECT_GT(min(c->run.made.thickness), 0.99*thickness);
    }
}


//- The height above the wall, in the duct's corners above both of its sides
static scalar heightOf(const curvedCase& c, const point& x)
{
    if (c.wall.patchNames.found("bottom"))
    {
        return x.z();
    }

    return min
    (
        min(x.y(), 1 - x.y()) < SMALL ? GREAT : min(x.y(), 1 - x.y()),
        min(x.z(), 1 - x.z())
    );
}


TEST(curvedSides, facesOnThemHaveTheFirstHeightThatWasAsked)
{
    for (const auto& c : curvedCases())
    {
        const prismLayers& layers = c->run.made.layers;
        scalarField asked(nCurvedLayers + 1);
        c->run.request.setHeights(0, thickness, asked);
        const Map<labelPair> border(c->wall.border.pointSides());
        stackHeights stack(layers);

        forAll(layers.faces, facei)
        {
            const face& f = layers.faces[facei];
            const bool isOnBorder = std::any_of
            (
                f.begin(), f.end(),
                [&](const label p) { return border.found(p); }
            );
            if (isOnBorder)
            {
                stack.compute(facei);
                EXPECT_NEAR(stack.heights()[0], asked[1], 0.01*asked[1]);
            }
        }
    }
}


TEST(curvedSides, columnsOnThemHaveTheFirstHeightThatWasAsked)
{
    for (const auto& c : curvedCases())
    {
        const prismLayers& layers = c->run.made.layers;
        scalarField asked(nCurvedLayers + 1);
        c->run.request.setHeights(0, thickness, asked);

        // Heights are those of faces; a point of a face may be a little off
        for (const label p : c->wall.border.pointSides().sortedToc())
        {
            EXPECT_NEAR(heightOf(*c, layers(p, 1)), asked[1], 0.03*asked[1]);
        }
    }
}


//- From the nearest part of a side patch
static scalar distanceFrom
(
    const curvedCase& c,
    const word& name,
    const point& x
)
{
    scalar least = GREAT;
    for (const sidePatch& side : c.wall.border.sides)
    {
        if (side.name == name)
        {
            least = min
            (
                least,
                side.isCurved()
              ? mag(x - side.shape->nearest(x).rawPoint())
              : mag(side.distance(x))
            );
        }
    }

    return least;
}


TEST(curvedSides, patchesAreOnTheFacesOfTheSurface)
{
    for (const auto& c : curvedCases())
    {
        for (const sidePatch& side : c->wall.border.sides)
        {
            const polyPatch& patch = c->mesh().boundaryMesh()[side.name];
            EXPECT_GT(patch.size(), 20);

            for (const point& x : patch.localPoints())
            {
                EXPECT_LT(distanceFrom(*c, side.name, x), 1e-12) << side.name;
            }
        }
    }
}


TEST(curvedSides, meshIsConformalAndFillsTheFluid)
{
    for (const auto& c : curvedCases())
    {
        EXPECT_FALSE(c->mesh().checkTopology(false));
        EXPECT_FALSE(c->mesh().checkFacePyramids(false));
        EXPECT_FALSE(c->mesh().checkClosedBoundary(false));
        EXPECT_FALSE(c->mesh().checkClosedCells(false));

        // By faces, and by other faces
        EXPECT_NEAR(sum(c->mesh().cellVolumes())/c->volume, 1, 0.003);
    }
}


// ************************************************************************* //
