/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreBoundary.H"
#include "makeHexCore.H"
#include "periodicCore.H"
#include "ranges.H"
#include "sidePair.H"
#include "sidePatchRemainders.H"

namespace Foam
{

//- Returns a box where it is in front of planes along the axes
static boundBox inFrontOf(const UList<sidePatch>& sides, boundBox box)
{
    for (const sidePatch& side : sides)
    {
        for (direction d = 0; d < 3; ++d)
        {
            if (side.normal[d] > 0.5)
            {
                box.max()[d] = min(box.max()[d], side.origin[d]);
            }
            else if (side.normal[d] < -0.5)
            {
                box.min()[d] = max(box.min()[d], side.origin[d]);
            }
        }
    }

    return box;
}


//- Returns for each side of a box (xMin, xMax, yMin, ...) the side patch on it,
//  or -1
static labelList planesOn(const UList<sidePatch>& sides)
{
    labelList planeOn(6, -1);
    forAll(sides, s)
    {
        for (direction d = 0; d < 3; ++d)
        {
            if (mag(sides[s].normal[d]) > 0.5)
            {
                planeOn[2*d + (sides[s].normal[d] > 0)] = s;
            }
        }
    }

    return planeOn;
}


//- Returns whether some sides are across each axis
static FixedList<bool, 3> directionsAcross(const UList<sidePatch>& sides)
{
    FixedList<bool, 3> areAcross(false);
    for (const sidePatch& side : sides)
    {
        for (direction d = 0; d < 3; ++d)
        {
            areAcross[d] = areAcross[d] || mag(side.normal[d]) > 0.5;
        }
    }

    return areAcross;
}


//- Appends a patch if there is none of that name
static void addPatch(const word& name, const word& type, meshPatches& patches)
{
    if (!patches.names.found(name))
    {
        patches.append(name, type);
    }
}


//- Whether cells of a core can stay on all sides: whether the side patches are
//  planes. For the hexahedra of an octree they must be along the axes, and
//  cyclic sides must be a translation apart.
static bool staysOnSides
(
    const prismLayers& layers,
    const farFieldDomain& domain,
    const bool isHexCore
)
{
    const bool turns = anyOf
    (
        pairsOf(domain.boundary.cyclicSides),
        [](const sidePair& pair) { return pair.toSecond.turns; }
    );

    return
        !(isHexCore && turns)
     && allOf(layers.border.sides, [&](const sidePatch& side)
        {
            const bool alongAxis = cmptMax(cmptMag(side.normal)) > 1 - 1e-12;

            return !side.isPart() && (alongAxis || !isHexCore);
        });
}


//- Returns the box of the far boundary and of the existing mesh; without these,
//  a box around the layers and the side patches
static boundBox coreBox(const prismLayers& layers, const farFieldDomain& domain)
{
    boundBox box(domain.boundary.surface.points, false);
    box.add(domain.core.points);

    if (box.empty())
    {
        box = boundBox(layers.points, false);
        for (const sidePatch& side : layers.border.sides)
        {
            box.add(side.points);
        }
        box.inflate(0.01);
    }

    return box;
}


//- Returns the box of hexahedra, with patches on its sides. If hexahedra stay
//  on all side patches, the box is in front of the side patches.
static hexCoreBox makeHexCoreBox
(
    const prismLayers& layers,
    const farFieldDomain& domain
)
{
    const farBoundary& boundary = domain.boundary;
    const List<sidePatch>& sides = layers.border.sides;
    const bool onSides = staysOnSides(layers, domain, true);
    hexCoreBox result;
    result.box = coreBox(layers, domain);
    if (onSides)
    {
        result.box = inFrontOf(sides, result.box);
    }

    if (!onSides || (boundary.boxPatches.empty() && sides.empty()))
    {
        return result;
    }

    result.isPeriodic = directionsAcross(boundary.cyclicSides);

    // Patches of the far boundary with a side that is on no plane
    const labelList planeOn(planesOn(sides));
    forAll(boundary.patchTypes, patchi)
    {
        forAll(boundary.boxPatches, i)
        {
            if (planeOn[i] < 0 && boundary.boxPatches[i] == patchi)
            {
                const word& name = boundary.surface.patchNames[patchi];
                addPatch(name, boundary.patchTypes[patchi], result.patches);
            }
        }
    }
    for (const sidePatch& side : sides)
    {
        addPatch(side.name, side.type, result.patches);
    }

    // Beyond the layers there is no patch without a far boundary
    result.sidePatches.setSize(6, result.patches.names.size());
    forAll(planeOn, i)
    {
        if (planeOn[i] >= 0 || boundary.boxPatches.size())
        {
            result.sidePatches[i] = result.patches.names.find
            (
                planeOn[i] >= 0
              ? sides[planeOn[i]].name
              : boundary.surface.patchNames[boundary.boxPatches[i]]
            );
        }
    }

    return result;
}


// * * * * * * * * * * * * * * *  Core Boundary  * * * * * * * * * * * * * * //

namespace
{

struct coreBoundaryMaker
{
    const prismLayers& layers;
    const wallSurface& outer;
    const farFieldControls& controls;
    const std::function<scalar(const point&)>& size;
    farFieldDomain& domain;
    coreCut& cut;

    const List<sidePatch>& sides = layers.border.sides;

    bool isHexCore() const { return controls.type == farFieldType::hexCore; }

    //- Whether cells of the core stay on the sides of the far boundary, on none
    //  of which layers end
    bool staysOnBox() const
    {
        return domain.boundary.boxPatches.size() && sides.empty()
            && staysOnSides(layers, domain, isHexCore());
    }

    //- Patches of the core for all side patches
    void addSidePatches()
    {
        polyMeshParts& core = domain.core;
        for (const sidePatch& side : sides)
        {
            if (!core.patches.names.found(side.name))
            {
                // Before the faces of no patch, if there are any
                core.topology.addEmptyPatch(core.patches.names.size());
                core.patches.append(side.name, side.type);
            }
        }
    }

    void setCore(const coreObstacles& obstacles)
    {
        if (isHexCore())
        {
            domain.core = makeHexCore
            (
                makeHexCoreBox(layers, domain), obstacles, size,
                controls.maxCells
            );
        }
    }

    //- The far boundary; the box of the core if there is no box yet
    farBoundary outerBox() const
    {
        if (domain.boundary.boxPatches.size() || !domain.core.nCells)
        {
            return domain.boundary;
        }

        farBoundaryControls boxControls;
        boxControls.type = farBoundaryType::box;
        boxControls.box = coreBox(layers, domain);

        return makeFarBoundary(boxControls, nullptr);
    }

    //- The pairs of patches of the core. A mesh may have pairs on which no
    //  layers end.
    List<labelPair> cyclicPatches()
    {
        List<labelPair> pairs
        (
            cyclicPatchesOf(domain.boundary.cyclicSides, domain.core)
        );
        if (!isHexCore())
        {
            pairs.append(cyclicPatchesBeside(sides, domain.core));
        }

        return pairs;
    }

    tetBoundary makeOnPlanes()
    {
        // Closed by coarse triangles of planes and box
        const farFieldBoundary boundary
        (
            makeFarFieldBoundary
            (
                layers, outerBox(), [](const point&) { return GREAT; }
            )
        );
        tetBoundary closing;
        closing.surface = boundary.surface;
        closing.columns = boundary.columns;

        const wallSearch surface(outer);
        const wallSurface closed(joined(outer, closing));
        checkBodies(closed, outer.faces.size());
        const wallSearch fluid(closed);
        const coreObstacles obstacles{surface, fluid};
        setCore(obstacles);
        const List<labelPair> cyclic(cyclicPatches());
        addSidePatches();
        cut = cutCore(domain.core, obstacles, controls.gap, sides, cyclic);

        tetBoundary result
        (
            makePlaneBoundary
            (
                layers, cut, domain.core.patches, domain.boundary.cyclicSides,
                size
            )
        );
        addCut(cut, domain.core.patches, result);

        return result;
    }

    tetBoundary makeAround()
    {
        if (!isHexCore() && sides.size())
        {
            FatalErrorInFunction
                << "The layers end on the side patch " << sides[0].name
                << ", which is no plane of surface.sidePlanes" << nl
                << "Layers that end on other side patches need a far field of"
                << " type tet or hexCore" << exit(FatalError);
        }

        const bool onBox = staysOnBox();
        tetBoundary result;
        if (!onBox)
        {
            result = makeTetBoundary(layers, domain.boundary, size);
        }

        const wallSurface both(joined(outer, result));
        checkBodies(both, outer.faces.size());
        const wallSearch surface(both);
        const coreObstacles obstacles{surface, surface};
        setCore(obstacles);
        List<labelPair> cyclic;
        if (onBox || !isHexCore())
        {
            cyclic = cyclicPatches();
        }
        cut = cutCore(domain.core, obstacles, controls.gap, {}, cyclic);
        addCut(cut, domain.core.patches, result);

        return result;
    }

    tetBoundary make()
    {
        const bool onPlanes =
            sides.size() && staysOnSides(layers, domain, isHexCore());

        return onPlanes ? makeOnPlanes() : makeAround();
    }
};

} // End anonymous namespace


tetBoundary makeCoreBoundary
(
    const prismLayers& layers,
    const wallSurface& outer,
    const farFieldControls& controls,
    const std::function<scalar(const point&)>& size,
    farFieldDomain& domain,
    coreCut& cut
)
{
    return coreBoundaryMaker
    {
        layers, outer, controls, size, domain, cut
    }.make();
}

} // End namespace Foam

// ************************************************************************* //
