/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFuzzCase.H"
#include "boxSides.H"
#include "embeddingFault.H"
#include "meshFarField.H"
#include "meshFaults.H"
#include "meshRegions.H"
#include "prismLayerMesh.H"
#include "throwingErrors.H"
#include "wallDefects.H"
#include "wallPointsError.H"

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


//- Whether layers reach a side of a box on which the wall does not end
static bool reachSides
(
    const prismLayers& layers,
    const List<sidePatch>& freeSides
)
{
    return std::any_of
    (
        freeSides.begin(), freeSides.end(), [&](const sidePatch& side)
        {
            return max(distancesTo(side, layers.points)) >= 0;
        }
    );
}


//- The far field at the sides of a box, unless a closed wall bounds the fluid
static void meshAtSides
(
    const fuzzWall& made,
    const prismLayerMesh& m,
    const bool hasPolygons,
    const listener& tell
)
{
    const farFieldControls& far = made.controls.farField;
    const List<sidePatch>& ends = made.wall.border.sides;

    if (reachSides(m.made.layers, freeSides(far.boundary, ends)))
    {
        tell("failed", "layers reach a side of the box");
    }
    else if
    (
        far.isWanted()
     && (made.controls.surface.fluidOutside || ends.size())
    )
    {
        fuzzFarField asked(fuzzFarFieldOf(made.wall, made.controls));
        asked.hasPolygons = hasPolygons;
        meshFarField(made.wall, m, asked, tell);
    }
}


static void mesh
(
    const fuzzCase& one,
    const fuzzWall& made,
    const listener& tell
)
{
    const wallSurface& wall = made.wall;
    const prismLayerControls& controls = made.controls;
    const prismLayerMesh m
    (
        makePrismLayerMesh
        (
            wall,
            controls,
            made.local,
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
        m.made.layers.nLayers != nAsked(controls.layers, m.request)
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
        fuzzFarField far(one.farField(wall, controls.layers));
        far.hasPolygons = one.hasPolygons;
        meshFarField(wall, m, far, tell);
    }
    else if (one.isAtSides)
    {
        meshAtSides(made, m, one.hasPolygons, tell);
    }
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


//- Drops the layers of patches of which the wall has no face: planes, ends and
//  remeshing may take all of a patch
static void dropEmptyPatches(const wallSurface& wall, layerControls& layers)
{
    DynamicList<patchLayers> kept;
    for (const patchLayers& p : layers.patches)
    {
        if (p.isSide || wall.patchNames.found(p.patches))
        {
            kept.append(p);
        }
    }
    layers.patches = kept;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

fuzzWall makeFuzzWall(const fuzzCase& one, const listener& tell)
{
    const throwingErrors throwing;
    fuzzWall made;
    wallSurface& surface = made.surface;
    tell("stage", "surface");
    try
    {
        surface = one.make(made.controls);
    }
    catch (const Foam::error& e)
    {
        // Of the polygon of a prism
        tell("skipped", oneLine(e.message()));
        return made;
    }

    if (one.isDamaged())
    {
        const std::string defects(oneLine(describe(findWallDefects(surface))));
        if (defects.size())
        {
            tell("skipped", defects);
            return made;
        }
        one.damage(surface, made.controls.surface.repair);
    }

    if (one.isAtSides)
    {
        tell("farField", kindOf(made.controls));
    }
    made.wall = prepareFuzzWall(one, surface, made.controls, tell);
    if (made.wall.faces.size())
    {
        dropEmptyPatches(made.wall, made.controls.layers);
        if (!one.isAtSides)
        {
            one.vary(made.wall, made.controls.layers, made.local);
        }
    }
    if (one.hasFarField)
    {
        // Layers below a far field are positive below triangles
        made.controls.farField.type = farFieldType::tet;
    }

    return made;
}


void meshFuzzCase(const fuzzCase& one, const listener& tell)
{
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();

    fuzzWall made;
    try
    {
        if (one.hasRegions)
        {
            meshRegionsCase(one, tell);
            return;
        }
        made = makeFuzzWall(one, tell);
        if (made.wall.faces.size())
        {
            mesh(one, made, tell);
        }
    }
    catch (const wallPointsError& e)
    {
        // What is stitched has the shape that damage gave it
        const bool isExpected =
            isOnBorder(made.wall, e.labels())
         || (
                one.repair == surfaceRepairControls::method::stitch
             && !one.isAssembly
            );
        tell(isExpected ? "skipped" : "failed", oneLine(e.message()));
    }
    catch (const Foam::error& e)
    {
        // As between walls that nearly touch
        const std::string text(oneLine(e.message()));
        const bool isFlat =
            text.find("Cells of the layers on ") == 0
         && text.find("flat but for rounding") != std::string::npos;
        tell(isFlat ? "skipped" : "failed", text);
    }
    catch (const std::exception& e)
    {
        tell("failed", "exception: " + oneLine(e.what()));
    }
}

} // End namespace Foam

// ************************************************************************* //
