/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreBoundary.H"
#include "makeHexCore.H"
#include "sidePatchRemainders.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Appends a patch if there is none of that name. Returns its label.
label patchOf(const word& name, const word& type, meshPatches& patches)
{
    const label patchi = patches.names.find(name);
    if (patchi >= 0)
    {
        return patchi;
    }
    patches.append(name, type);

    return patches.names.size() - 1;
}


struct coreBoundaryMaker
{
    const prismLayers& layers;
    const wallSurface& outer;
    const farFieldControls& controls;
    const std::function<scalar(const point&)>& size;
    farFieldDomain& domain;
    coreCut& cut;

    const List<sidePatch>& sides = layers.border.sides;

    bool isHexCore() const { return controls.type == "hexCore"; }

    //- Whether cells of the core stay on all side patches
    bool staysOnSides() const;

    //- The box of the far boundary, or of the mesh, or one around the layers
    boundBox box() const;

    //- That box where it is in front of the planes
    boundBox boxBehindPlanes() const;

    //- The box of hexahedra, with patches on its sides
    hexCoreBox hexBox() const;

    //- Patches of the core for all side patches
    void addSidePatches();

    void setCore(const coreObstacles& obstacles);

    tetBoundary makeOnPlanes();

    tetBoundary makeAround();

    tetBoundary make()
    {
        return sides.size() && staysOnSides() ? makeOnPlanes() : makeAround();
    }
};


bool coreBoundaryMaker::staysOnSides() const
{
    for (const sidePatch& side : sides)
    {
        const bool alongAxis = cmptMax(cmptMag(side.normal)) > 1 - 1e-12;

        if (side.isPart() || (isHexCore() && !alongAxis))
        {
            return false;
        }
    }

    return true;
}


boundBox coreBoundaryMaker::box() const
{
    boundBox box(domain.boundary.surface.points, false);
    box.add(domain.core.points);

    if (box.empty())
    {
        box = boundBox(layers.points, false);
        box.inflate(0.01);
    }

    return box;
}


boundBox coreBoundaryMaker::boxBehindPlanes() const
{
    boundBox box(this->box());

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


hexCoreBox coreBoundaryMaker::hexBox() const
{
    const farBoundary& boundary = domain.boundary;
    const bool onSides = sides.empty() || staysOnSides();
    hexCoreBox result;
    result.box = onSides ? boxBehindPlanes() : box();

    if (!onSides || (boundary.boxPatches.empty() && sides.empty()))
    {
        return result;
    }

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

    // Patches of the far boundary with a side that is on no plane
    forAll(boundary.patchTypes, patchi)
    {
        forAll(boundary.boxPatches, i)
        {
            if (planeOn[i] < 0 && boundary.boxPatches[i] == patchi)
            {
                const word& name = boundary.surface.patchNames[patchi];
                patchOf(name, boundary.patchTypes[patchi], result.patches);
            }
        }
    }
    for (const sidePatch& side : sides)
    {
        patchOf(side.name, side.type, result.patches);
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
        domain.core =
            makeHexCore(hexBox(), obstacles, size, controls.maxCells);
    }
}


tetBoundary coreBoundaryMaker::makeOnPlanes()
{
    // Closed by coarse triangles of planes and box
    farBoundary coarse(domain.boundary);
    if (coarse.boxPatches.empty() && domain.core.nCells)
    {
        farBoundaryControls boxControls;
        boxControls.type = "box";
        boxControls.box = box();
        coarse = makeFarBoundary(boxControls, nullptr);
    }
    const farFieldBoundary boundary
    (
        makeFarFieldBoundary
        (
            layers, coarse, [](const point&) { return GREAT; }
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
