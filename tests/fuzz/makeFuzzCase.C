/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fuzzCase.H"
#include "meshRegions.H"
#include "addNeedles.H"
#include "boundBox.H"
#include "damageSurface.H"
#include "layerSpacing.H"
#include "wallChanges.H"

#include <cstdint>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A seed that has nothing to do with that of the next index: the finaliser
//  of the splitmix64 generator
static label mixed(const label seed, const label index)
{
    std::uint64_t x = (std::uint64_t(seed) << 32) + std::uint64_t(index);

    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30))*0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27))*0x94d049bb133111ebu;
    x ^= x >> 31;

    return label(x & 0x7fffffff);
}


//- The surface of a case; a far field is for small ones
static wallSurface makeSurface
(
    const fuzzCase& one,
    Random& random,
    prismLayerControls& controls
)
{
    using randomSurfaces::kind;

    if (one.hasRegions)
    {
        return one.hasSheets ? sheetsInBox(random) : assemblyInBox(random);
    }
    if (one.isAssembly)
    {
        return randomSurfaces::assembly(random);
    }
    if (one.isPeriodic)
    {
        return randomSurfaces::periodicBody(one.kind, random, controls);
    }
    if (one.isAtSides)
    {
        return randomSurfaces::bodiesAtSides(one.kind, random, controls);
    }
    if (!one.hasFarField)
    {
        return randomSurfaces::makeRandomSurface(one.kind, random, controls);
    }

    const label mostFaces = 300;
    wallSurface surface;
    do
    {
        surface =
            one.kind == kind::cutBody && randomSurfaces::chance(random, 0.7)
          ? randomSurfaces::cutBody(random, controls, true)
          : randomSurfaces::makeRandomSurface(one.kind, random, controls);
    } while (surface.faces.size() > mostFaces);

    return surface;
}


//- Two patches on the sides of a plane, the second of another thickness, in
//  place of the first patch
static void splitPatches
(
    wallSurface& surface,
    layerControls& controls,
    Random& random
)
{
    const vector normal(randomSurfaces::unitVector(random));
    const point centre(boundBox(surface.points, false).centre());
    const label otherPatch = surface.patchNames.size();

    surface.patchNames.append("other");
    forAll(surface.faces, i)
    {
        const vector offset(surface.points[surface.faces[i][0]] - centre);
        label& patchi = surface.patchIDs[i];
        patchi = patchi == 0 && (normal & offset) > 0 ? otherPatch : patchi;
    }

    patchLayers other;
    other.patches = word("other");
    other.heights.firstLayerThickness = controls.heights.firstLayerThickness
       *randomSurfaces::logUniform(random, 0.2, 5);
    controls.patches.append(other);
}


//- A region on one side of a plane, of other layers
static void addRegion
(
    const wallSurface& wall,
    layerControls& controls,
    localHeights& local,
    Random& random
)
{
    const vector normal(randomSurfaces::unitVector(random));
    const point& origin =
        wall.points[random.position<label>(0, wall.points.size() - 1)];

    layerRegion region;
    region.name = "region";
    region.heights.nSurfaceLayers = random.position<label>(1, 20);
    region.heights.expansionRatio = random.position<scalar>(1, 1.4);
    region.heights.relativeSizes = randomSurfaces::chance(random, 0.3);
    region.heights.firstLayerThickness =
        region.heights.relativeSizes
      ? randomSurfaces::logUniform(random, 0.001, 0.1)
      : controls.heights.firstLayerThickness
       *randomSurfaces::logUniform(random, 0.2, 5);
    controls.regions = List<layerRegion>(1, region);

    boolList in(wall.points.size());
    forAll(in, p)
    {
        in[p] = (normal & (wall.points[p] - origin)) >= 0;
    }
    local.inRegion = List<boolList>(1, in);
}


//- First heights that are rough along the wall
static void addValues
(
    const wallSurface& wall,
    const layerControls& controls,
    localHeights& local,
    Random& random
)
{
    local.firstThickness.setSize(wall.points.size());

    for (scalar& h : local.firstThickness)
    {
        h = controls.heights.firstLayerThickness
           *randomSurfaces::logUniform(random, 0.3, 3);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wallSurface Foam::fuzzCase::make(prismLayerControls& controls) const
{
    Random random(mixed(seed, index));
    wallSurface surface(makeSurface(*this, random, controls));
    cutReflexFaces(surface);
    if (hasNeedles && !hasSides())
    {
        Random needles(mixed(seed + 4, index));
        randomSurfaces::addNeedles(surface, needles);
    }

    const scalar size = cmptMax(boundBox(surface.points, false).span());
    const scalar total = size*randomSurfaces::logUniform(random, 0.003, 0.1);
    const scalar ratio = random.position<scalar>(1, 1.5);
    layerControls& layers = controls.layers;

    layers.heights.nSurfaceLayers = random.position<label>(1, 20);
    layers.heights.expansionRatio = ratio;
    layers.heights.firstLayerThickness =
        total/totalThickness(layers.heights.nSurfaceLayers, 1, ratio);

    if (!hasRegions && randomSurfaces::chance(random, 0.2))
    {
        splitPatches(surface, layers, random);
    }

    // Multiple normals by choice: at sharp edges and corners
    if (randomSurfaces::chance(random, 0.3))
    {
        layers.multipleNormalsAngle = random.position<scalar>(0, 60);
    }

    if (hasSides())
    {
        return surface;
    }
    if (!isAtSides)
    {
        controls.surface.repair.repair = repair;
    }
    if (isRemeshed)
    {
        using randomSurfaces::logUniform;
        Random lengths(mixed(seed + 1, index));
        surfaceRemeshControls& remesh = controls.surface.remesh;
        remesh.active = true;
        remesh.maxEdge = size*logUniform(lengths, 0.08, 0.5);
        remesh.minEdge = remesh.maxEdge*logUniform(lengths, 0.1, 0.8);
        remesh.deviation = size*logUniform(lengths, 1e-4, 0.05);
        remesh.featureAngle = lengths.position<scalar>(10, 80);
    }

    return surface;
}


void Foam::fuzzCase::damage
(
    wallSurface& surface,
    surfaceRepairControls& controls
) const
{
    Random random(mixed(seed + 2, index));
    if (enclosedVolume(surface) < 0)
    {
        for (face& f : surface.faces)
        {
            f.flip();
        }
    }
    randomSurfaces::damage(surface, random);

    const scalar size = boundBox(surface.points, false).mag();
    controls.size = size*randomSurfaces::logUniform(random, 0.02, 0.2);
    controls.gap = size*randomSurfaces::logUniform(random, 1e-6, 1e-2);
    controls.hole = size*randomSurfaces::logUniform(random, 1e-2, 1);
}


void Foam::fuzzCase::vary
(
    const wallSurface& wall,
    layerControls& layers,
    localHeights& local
) const
{
    // Of other random numbers, so that the other cases are as they are
    Random more(mixed(seed, index) + 1);

    if (randomSurfaces::chance(more, 0.15))
    {
        addRegion(wall, layers, local, more);
    }
    if (randomSurfaces::chance(more, 0.1))
    {
        addValues(wall, layers, local, more);
    }
    if (randomSurfaces::chance(more, 0.1) && layers.patches.size())
    {
        patchLayers& last = layers.patches.last();
        const label n = more.position<label>(1, 20);
        last.heights.nSurfaceLayers = last.isSide ? 0 : n;
    }
    if (randomSurfaces::chance(more, 0.05) && layers.regions.empty())
    {
        layers.heights.nSurfaceLayers = 0;
        layers.heights.expansionRatio =
            max(layers.heights.expansionRatio, scalar(1.1));
        layers.finalAspect = more.position<scalar>(0.05, 1);

        for (patchLayers& entry : layers.patches)
        {
            entry.heights.nSurfaceLayers = 0;
        }
    }
}


Foam::fuzzFarField Foam::fuzzCase::farField
(
    const wallSurface& wall,
    const layerControls& layers
) const
{
    const heightEntries& heights = layers.heights;
    const label n = heights.nSurfaceLayers;
    const scalar size = cmptMax(boundBox(wall.points, false).span());
    const scalar thickness =
        n
      ? heights.firstLayerThickness
       *totalThickness(n, 1, heights.expansionRatio)
      : 0.05*size;
    Random random(mixed(seed + 3, index));

    return makeFuzzFarField(wall, 1.2*thickness, random);
}


// ************************************************************************* //
