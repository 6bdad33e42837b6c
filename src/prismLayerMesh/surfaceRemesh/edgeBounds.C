/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "edgeBounds.H"
#include "FlatOutput.H"
#include "wallClearance.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void edgeBounds::applyRegions
(
    const pointField& points,
    scalarField& bounds
) const
{
    forAll(regions_, i)
    {
        const scalar maxEdge = controls_.regions[i].maxEdge;
        const scalarField distances(regions_[i].distances(points));

        forAll(points, p)
        {
            bounds[p] =
                distances[p] > 0
              ? min
                (
                    bounds[p],
                    maxEdge + (controls_.growthRate - 1)*distances[p]
                )
              : maxEdge;
        }
    }
}


void edgeBounds::applyGaps
(
    const wallSurface& surface,
    scalarField& bounds
) const
{
    const scalar perRadius = 2*controls_.edgePerGap;
    const vectorField normals(surface.faceNormals());

    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        scalar longest = 0;
        for (const label p : f)
        {
            longest = max(longest, bounds[p]);
        }

        const scalar radius = roomAlong
        (
            search_(), f.centre(surface.points), normals[facei],
            longest/perRadius
        );
        for (const label p : f)
        {
            bounds[p] =
                min(bounds[p], max(perRadius*radius, controls_.minEdge));
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

edgeBounds::edgeBounds
(
    const wallSurface& given,
    const surfaceRemeshControls& controls,
    const PtrList<regionSearch>& regions
)
:
    controls_(controls),
    regions_(regions),
    ofPatches_(given.patchNames.size(), controls.maxEdge),
    search_(controls.edgePerGap > 0 ? new wallSearch(given) : nullptr)
{
    for (const patchEdges& entry : controls.patches)
    {
        bool matches = false;

        forAll(given.patchNames, patchi)
        {
            if (entry.patches.match(given.patchNames[patchi]))
            {
                ofPatches_[patchi] = entry.maxEdge;
                matches = true;
            }
        }

        if (!matches)
        {
            FatalErrorInFunction
                << "The entry " << entry.patches << " of surface.remesh.patches"
                << " matches no patch of the surface" << nl
                << "Its patches: " << flatOutput(given.patchNames)
                << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalarField edgeBounds::atPoints(const wallSurface& surface) const
{
    scalarField bounds(surface.points.size(), GREAT);

    forAll(surface.faces, facei)
    {
        for (const label p : surface.faces[facei])
        {
            bounds[p] = min(bounds[p], ofPatches_[surface.patchIDs[facei]]);
        }
    }

    applyRegions(surface.points, bounds);
    if (search_.valid())
    {
        applyGaps(surface, bounds);
    }

    return bounds;
}


void edgeBounds::requirePointsInRegions(const wallSurface& surface) const
{
    forAll(regions_, i)
    {
        if (!regions_[i].contains(surface.points).found(true))
        {
            FatalErrorInFunction
                << "There is no point of the surface in the region "
                << controls_.regions[i].name << " of surface.remesh.regions"
                << exit(FatalError);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
