/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreBox.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


//- Appends a patch if there is none of that name
static void addPatch(const word& name, const word& type, meshPatches& patches)
{
    if (!patches.names.found(name))
    {
        patches.append(name, type);
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool staysOnSides(const UList<sidePatch>& sides, const bool isHexCore)
{
    return allOf(sides, [&](const sidePatch& side)
    {
        const bool alongAxis = cmptMax(cmptMag(side.normal)) > 1 - 1e-12;

        return !side.isPart() && (alongAxis || !isHexCore);
    });
}


boundBox coreBox(const prismLayers& layers, const farFieldDomain& domain)
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


hexCoreBox makeHexCoreBox
(
    const prismLayers& layers,
    const farFieldDomain& domain
)
{
    const farBoundary& boundary = domain.boundary;
    const List<sidePatch>& sides = layers.border.sides;
    const bool onSides = staysOnSides(sides, true);
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

} // End namespace Foam

// ************************************************************************* //
