/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fuzzCase.H"
#include "addNeedles.H"
#include "boundBox.H"
#include "cutReflexFaces.H"
#include "layerSpacing.H"
#include "damageSurface.H"
#include "remeshSurface.H"
#include "repairSurface.H"

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
static wallSurface makeSurface(const fuzzCase& one, Random& random)
{
    using randomSurfaces::kind;

    if (one.isAssembly)
    {
        return randomSurfaces::assembly(random);
    }
    if (!one.hasFarField)
    {
        return randomSurfaces::makeRandomSurface(one.kind, random);
    }

    const label mostFaces = 300;
    wallSurface wall;
    do
    {
        wall =
            one.kind == kind::cutBody && randomSurfaces::chance(random, 0.7)
          ? randomSurfaces::cutBody(random, true)
          : randomSurfaces::makeRandomSurface(one.kind, random);
    } while (wall.faces.size() > mostFaces);

    return wall;
}


//- Two patches on the sides of a plane, the second of another thickness
static void splitPatches
(
    wallSurface& wall,
    layerControls& controls,
    Random& random
)
{
    const vector normal(randomSurfaces::unitVector(random));
    const point centre(boundBox(wall.points, false).centre());

    wall.patchNames.append("other");
    forAll(wall.faces, i)
    {
        const vector offset(wall.points[wall.faces[i][0]] - centre);
        wall.patchIDs[i] = (normal & offset) > 0;
    }

    patchLayers other;
    other.patches = word("other");
    other.heights.firstLayerThickness = controls.heights.firstLayerThickness
       *randomSurfaces::logUniform(random, 0.2, 5);
    controls.patches = List<patchLayers>(1, other);
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


//- What a few of the cases have. Of other random numbers, so that these leave
//  the other cases as they are
static void addVariants
(
    const wallSurface& wall,
    layerControls& layers,
    localHeights& local,
    Random& more
)
{
    heightEntries& heights = layers.heights;

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
        layers.patches[0].heights.nSurfaceLayers = more.position<label>(1, 20);
    }
    if (randomSurfaces::chance(more, 0.05) && layers.regions.empty())
    {
        heights.nSurfaceLayers = 0;
        heights.expansionRatio = max(heights.expansionRatio, scalar(1.1));
        layers.finalAspect = more.position<scalar>(0.05, 1);

        for (patchLayers& entry : layers.patches)
        {
            entry.heights.nSurfaceLayers = 0;
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fuzzCase::make
(
    wallSurface& wall,
    prismLayerControls& controls,
    localHeights& local
) const
{
    Random random(mixed(seed, index));
    wall = makeSurface(*this, random);
    cutReflexFaces(wall);
    if (hasNeedles && wall.border.sides.empty())
    {
        Random needles(mixed(seed + 4, index));
        randomSurfaces::addNeedles(wall, needles);
    }

    const scalar size = cmptMax(boundBox(wall.points, false).span());
    const scalar total = size*randomSurfaces::logUniform(random, 0.003, 0.1);
    const scalar ratio = random.position<scalar>(1, 1.5);
    layerControls& layers = controls.layers;

    layers.heights.nSurfaceLayers = random.position<label>(1, 20);
    layers.heights.expansionRatio = ratio;
    layers.heights.firstLayerThickness =
        total/totalThickness(layers.heights.nSurfaceLayers, 1, ratio);

    if (randomSurfaces::chance(random, 0.2))
    {
        splitPatches(wall, layers, random);
    }

    // Multiple normals by choice: at sharp edges and corners
    if (randomSurfaces::chance(random, 0.3))
    {
        layers.multipleNormalsAngle = random.position<scalar>(0, 60);
    }

    Random more(mixed(seed, index) + 1);
    addVariants(wall, layers, local, more);
}


Foam::wallSurface Foam::fuzzCase::remeshed
(
    const wallSurface& wall
) const
{
    Random random(mixed(seed + 1, index));
    const scalar size = cmptMax(boundBox(wall.points, false).span());

    surfaceRemeshControls controls;
    controls.maxEdge = size*randomSurfaces::logUniform(random, 0.08, 0.5);
    controls.minEdge =
        controls.maxEdge*randomSurfaces::logUniform(random, 0.1, 0.8);
    controls.deviation = size*randomSurfaces::logUniform(random, 1e-4, 0.05);
    controls.featureAngle = random.position<scalar>(10, 80);

    return remeshSurface(wall, controls).surface;
}


Foam::wallSurface Foam::fuzzCase::repaired
(
    const wallSurface& wall
) const
{
    if (isAssembly)
    {
        wallSurfaceControls controls;
        controls.repair.repair = surfaceRepairControls::method::stitch;

        return repairSurface(wall, controls).surface;
    }

    Random random(mixed(seed + 2, index));
    wallSurface surface(wall);
    if (enclosedVolume(surface) < 0)
    {
        for (face& f : surface.faces)
        {
            f.flip();
        }
    }
    randomSurfaces::damage(surface, random);

    const scalar size = boundBox(surface.points, false).mag();
    wallSurfaceControls controls;
    controls.repair.repair = repair;
    controls.repair.size = size*randomSurfaces::logUniform(random, 0.02, 0.2);
    controls.repair.gap = size*randomSurfaces::logUniform(random, 1e-6, 1e-2);
    controls.repair.hole = size*randomSurfaces::logUniform(random, 1e-2, 1);

    return repairSurface(surface, controls).surface;
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
