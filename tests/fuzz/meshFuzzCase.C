/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFuzzCase.H"
#include "cutBlindFaces.H"
#include "cutReflexFaces.H"
#include "embeddingFault.H"
#include "meshFarField.H"
#include "meshFaults.H"
#include "prismLayerMesh.H"
#include "wallDefects.H"
#include "wallPointsError.H"

#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Layers that there must be: the most that any part of the wall asks for
static label nAsked(const layerControls& controls, const layerSpacing& asked)
{
    if (controls.automatic())
    {
        return asked.nLayers;
    }

    label n = controls.heights.nSurfaceLayers;

    for (const patchLayers& entry : controls.patches)
    {
        n = max(n, entry.heights.nSurfaceLayers);
    }
    for (const layerRegion& region : controls.regions)
    {
        n = max(n, region.heights.nSurfaceLayers);
    }

    // It may be that no point is left to those who ask for the most
    return min(n, max(asked.layersAsked));
}


static void mesh
(
    const fuzzCase& one,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const listener& tell
)
{
    const prismLayerMesh m
    (
        makePrismLayerMesh
        (
            wall,
            controls,
            local,
            stageObserver
            {
                [&](const word& stage) { tell("stage", stage); },
                [](const string&) {}
            }
        )
    );

    tell("stage", "checks");

    if (m.noField.size())
    {
        tell("noField", oneLine(m.noField));
    }

    const std::string fault(findMeshFault(wall, m.made.layers));
    const std::string embedding(findEmbeddingFault(wall, m.made.layers));

    if (!m.certificate.valid())
    {
        tell("failed", "the certificate is not valid");
    }
    else if
    (
        m.made.layers.nLayers != nAsked(controls.layers, m.heights.request)
    )
    {
        tell("failed", "the number of layers is not what was asked for");
    }
    else if (fault.size() || embedding.size())
    {
        tell("failed", oneLine(fault + embedding));
    }
    else if (one.hasFarField)
    {
        const fuzzFarField far(one.farField(wall, controls.layers));
        meshFarField(wall, m, far, tell);
    }
}


//- Gives the wall new triangles; what was said of its old points is forgotten
static void remesh
(
    const fuzzCase& one,
    wallSurface& wall,
    prismLayerControls& controls,
    localHeights& local,
    const listener& tell
)
{
    tell("stage", "remesh");
    controls.layers.regions.clear();
    local = localHeights();
    wall = one.remeshed(wall);
    tell(findWallDefects(wall).empty() ? "stage" : "failed", "defects");
}


//- Damages and repairs the wall; what was said of its old points is forgotten.
//  Returns whether it has no defects then, as all have that are wrapped.
static bool repair
(
    const fuzzCase& one,
    wallSurface& wall,
    prismLayerControls& controls,
    localHeights& local,
    const listener& tell
)
{
    tell("stage", "repair");
    controls.layers.regions.clear();
    local = localHeights();
    wall = one.repaired(wall);

    const std::string defects(oneLine(describe(findWallDefects(wall))));
    const bool mustBeGood =
        one.isAssembly || one.repair == surfaceRepairControls::method::wrap;
    if (defects.size())
    {
        tell(mustBeGood ? "failed" : "skipped", defects);
    }

    return defects.empty();
}


//- Makes the wall and its layers. Returns whether it has no defects.
static bool make
(
    const fuzzCase& one,
    wallSurface& wall,
    prismLayerControls& controls,
    localHeights& local,
    const listener& tell
)
{
    try
    {
        tell("stage", "surface");
        one.make(wall, controls, local);
        if (one.isAssembly)
        {
            return true;
        }

        const std::string defects
        (
            oneLine(describe(findWallDefects(wall, wall.border.sides.size())))
        );
        if (defects.size())
        {
            tell("skipped", defects);
        }

        return defects.empty();
    }
    catch (const Foam::error& e)
    {
        // Of the polygon of a prism
        tell("skipped", oneLine(e.message()));
        return false;
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string oneLine(const std::string& text)
{
    std::istringstream words(text);
    std::string word, line;

    while (words >> word)
    {
        line += (line.empty() ? "" : " ") + word;
    }

    return line;
}


//- In a knife edge between wall and side patch there may be no layers
static bool isOnBorder(const wallSurface& wall, const labelUList& points)
{
    const Map<labelPair> border(wall.border.pointSides());

    return std::all_of
    (
        points.begin(), points.end(),
        [&](const label p) { return border.found(p); }
    );
}


void meshFuzzCase(const fuzzCase& one, const listener& tell)
{
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();

    wallSurface wall;
    prismLayerControls controls;
    localHeights local;
    if (!make(one, wall, controls, local, tell))
    {
        return;
    }

    try
    {
        if
        (
            one.repair != surfaceRepairControls::method::none
         && wall.border.sides.empty()
         && !repair(one, wall, controls, local, tell)
        )
        {
            return;
        }
        if (one.isRemeshed && wall.border.sides.empty())
        {
            remesh(one, wall, controls, local, tell);
        }
        if (one.repair != surfaceRepairControls::method::none)
        {
            cutReflexFaces(wall);
        }
        cutBlindFaces(wall);
        mesh(one, wall, controls, local, tell);
    }
    catch (const wallPointsError& e)
    {
        // What is stitched has the shape that damage gave it
        const bool isExpected =
            isOnBorder(wall, e.labels())
         || (
                one.repair == surfaceRepairControls::method::stitch
             && !one.isAssembly
            );
        tell(isExpected ? "skipped" : "failed", oneLine(e.message()));
    }
    catch (const Foam::error& e)
    {
        tell("failed", oneLine(e.message()));
    }
    catch (const std::exception& e)
    {
        tell("failed", "exception: " + oneLine(e.what()));
    }
}

} // End namespace Foam

// ************************************************************************* //
