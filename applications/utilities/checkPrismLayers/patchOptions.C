/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchOptions.H"
#include "prismPolyMesh.H"
#include "ranges.H"
#include "wallPolyPatch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The patches of an option in ascending order, or the default ones
static labelList patchesOf
(
    const argList& args,
    const word& option,
    const polyBoundaryMesh& patches,
    const labelList& defaults
)
{
    if (!args.found(option))
    {
        return defaults;
    }

    const wordRes names(args.getList<wordRe>(option));
    const labelList found(patches.patchSet(names).sortedToc());

    if (found.empty())
    {
        FatalErrorInFunction
            << "No patch is called " << args[option].c_str() << ", only "
            << patches.names() << exit(FatalError);
    }

    return found;
}


//- Errors: FatalError if a patch is a wall and an outer one
static void requireApart
(
    const polyBoundaryMesh& patches,
    const labelUList& walls,
    const labelUList& outer
)
{
    for (const label patchi : outer)
    {
        if (walls.found(patchi))
        {
            FatalErrorInFunction
                << "Patch " << patches[patchi].name()
                << " is in -walls and in -outer" << exit(FatalError);
        }
    }
}


//- The patches of type wall that have layers, or might have; names the others.
//  beyond: cells that are not of the layers, empty if that is unknown
static labelList wallsOf(const polyBoundaryMesh& patches, const bitSet& beyond)
{
    DynamicList<label> walls;
    DynamicList<word> bare;
    for
    (
        const label patchi : patches.findPatchIDs<wallPolyPatch>().sortedToc()
    )
    {
        const polyPatch& patch = patches[patchi];
        const bool isBare =
            patch.size() && beyond.size()
         && allOf
            (
                patch.faceCells(),
                [&](const label celli) { return beyond.test(celli); }
            );
        if (isBare)
        {
            bare.append(patch.name());
        }
        else
        {
            walls.append(patchi);
        }
    }

    if (bare.size())
    {
        Info<< "Walls that no cell of the cellZone " << boundaryLayerName
            << " is on, and that are not counted: " << listed(bare).c_str()
            << nl << endl;
    }

    return labelList(std::move(walls));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

namedPatches readPatchOptions
(
    const argList& args,
    const polyBoundaryMesh& patches,
    const bitSet& beyond
)
{
    const label outeri = patches.findPatchID(layerOuterName);
    const namedPatches named
    {
        patchesOf
        (
            args, "walls", patches,
            args.found("walls") ? labelList() : wallsOf(patches, beyond)
        ),
        patchesOf
        (
            args, "outer", patches, labelList(outeri < 0 ? 0 : 1, outeri)
        )
    };
    requireApart(patches, named.walls, named.outer);

    return named;
}


labelList facesOf(const polyBoundaryMesh& patches, const labelUList& which)
{
    DynamicList<label> faces;

    for (const label patchi : which)
    {
        const polyPatch& patch = patches[patchi];
        faces.append(identity(patch.size(), patch.start()));
    }

    return labelList(std::move(faces));
}

} // End namespace Foam

// ************************************************************************* //
