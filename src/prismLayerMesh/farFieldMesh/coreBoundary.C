/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreBoundary.H"
#include "coreBox.H"
#include "makeHexCore.H"
#include "sidePatchRemainders.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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

    //- Patches of the core for all side patches
    void addSidePatches();

    void setCore(const coreObstacles& obstacles);

    //- The far boundary; the box of the core if there is no box yet
    farBoundary outerBox() const;

    tetBoundary makeOnPlanes();

    tetBoundary makeAround();

    tetBoundary make()
    {
        const bool onPlanes = sides.size() && staysOnSides(sides, isHexCore());

        return onPlanes ? makeOnPlanes() : makeAround();
    }
};


void coreBoundaryMaker::addSidePatches()
{
    polyMeshParts& core = domain.core;
    for (const sidePatch& side : sides)
    {
        if (!core.patches.names.found(side.name))
        {
            // Before the faces of no patch, if there are any
            const label n = core.patches.names.size();
            const label end = n < core.topology.patchStarts.size()
              ? core.topology.patchStarts[n] : core.topology.faces.size();
            const label nNameless = core.topology.patchStarts.size() - n;
            labelList starts(SubList<label>(core.topology.patchStarts, n));
            labelList sizes(SubList<label>(core.topology.patchSizes, n));
            starts.append(end);
            sizes.append(0);
            starts.append
            (
                SubList<label>(core.topology.patchStarts, nNameless, n)
            );
            sizes.append
            (
                SubList<label>(core.topology.patchSizes, nNameless, n)
            );
            core.topology.patchStarts = starts;
            core.topology.patchSizes = sizes;
            core.patches.append(side.name, side.type);
        }
    }
}


void coreBoundaryMaker::setCore(const coreObstacles& obstacles)
{
    if (isHexCore())
    {
        domain.core = makeHexCore
        (
            makeHexCoreBox(layers, domain), obstacles, size, controls.maxCells
        );
    }
}


farBoundary coreBoundaryMaker::outerBox() const
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


tetBoundary coreBoundaryMaker::makeOnPlanes()
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
    addSidePatches();
    cut = cutCore(domain.core, obstacles, controls.gap, sides);

    tetBoundary result
    (
        makePlaneBoundary(layers, cut, domain.core.patches, size)
    );
    addCut(cut, domain.core.patches, result);

    return result;
}


tetBoundary coreBoundaryMaker::makeAround()
{
    if (!isHexCore() && sides.size())
    {
        FatalErrorInFunction
            << "The layers end on the side patch " << sides[0].name
            << ", which is no plane of surface.sidePlanes" << nl
            << "Layers that end on other side patches need a far field of type"
            << " tet or hexCore" << exit(FatalError);
    }

    tetBoundary result;
    if (domain.boundary.boxPatches.empty() || sides.size())
    {
        result = makeTetBoundary(layers, domain.boundary, size);
    }

    const wallSurface both(joined(outer, result));
    checkBodies(both, outer.faces.size());
    const wallSearch surface(both);
    const coreObstacles obstacles{surface, surface};
    setCore(obstacles);
    cut = cutCore(domain.core, obstacles, controls.gap);
    addCut(cut, domain.core.patches, result);

    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
