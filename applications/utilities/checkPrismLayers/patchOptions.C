/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchOptions.H"
#include "prismPolyMesh.H"
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

namedPatches readPatchOptions
(
    const argList& args,
    const polyBoundaryMesh& patches
)
{
    const label outeri = patches.findPatchID(layerOuterName);
    const namedPatches named
    {
        patchesOf
        (
            args, "walls", patches,
            patches.findPatchIDs<wallPolyPatch>().sortedToc()
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
