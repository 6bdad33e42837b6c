/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledPatches.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Number of the faces of a patch whose cells stay
static label nStaying
(
    const polyMeshParts& core,
    const stayingCells& stays,
    const label patchi
)
{
    const polyMeshTopology& t = core.topology;
    const SubList<label> owners
    (
        t.owner, t.patchSizes[patchi], t.patchStarts[patchi]
    );

    return countOf(owners, [&](const label celli) { return stays[celli]; });
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void refuseCoupled
(
    const polyMeshParts& core,
    const stayingCells& stays,
    const coreObstacles& obstacles,
    const label patchi
)
{
    const polyMeshTopology& t = core.topology;
    const label start = t.patchStarts[patchi];
    const dictionary& entry = core.patches.entries[patchi];
    const word neighbour(entry.lookupOrDefault<word>("neighbourPatch", ""));
    const label other = core.patches.names.find(neighbour);

    // Both of a pair may be behind the obstacles
    const bool isGone =
        !nStaying(core, stays, patchi)
     && (other < 0 || !nStaying(core, stays, other));

    for (label facei = start; facei < start + t.patchSizes[patchi]; ++facei)
    {
        if
        (
            stays[t.owner[facei]]
         || (isGone && !stays.inFluid(facei))
        )
        {
            continue;
        }

        const point centre(t.faces[facei].centre(core.points));
        FatalErrorInFunction
            << "The layers need room at the patch "
            << core.patches.names[patchi] << " of type "
            << entry.get<word>("type") << ", at " << centre << ", "
            << obstacles.surface.footOf(centre).distance << " from them" << nl
            << "Make the cells between the patch and the layers smaller, or"
            << " farField.gap, or move the patch away" << exit(FatalError);
    }
}

} // End namespace Foam

// ************************************************************************* //
