/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readDomain.H"
#include "makeSizeBounds.H"
#include "prismPolyMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Errors: FatalError if the wall has a patch of the far boundary
static void requireNotOf(const wallSurface& wall, const word& farPatch)
{
    if (prismPatchNames(wall.patchNames).found(farPatch))
    {
        FatalErrorInFunction
            << "The far boundary and the wall both have a patch " << farPatch
            << ". Rename one of them" << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farFieldDomain readFarField
(
    const prismCase& files,
    const wallSurface& wall,
    const bool fluidOutside,
    const farFieldControls& controls,
    const Time& time,
    stageLog& log
)
{
    farFieldDomain domain;

    if (!controls.isWanted())
    {
        return domain;
    }

    if
    (
        !fluidOutside && controls.boundary.type != farBoundaryType::none
     && wall.border.sides.empty()
    )
    {
        FatalErrorInFunction
            << "The fluid is inside of the wall: there is no far boundary"
            << exit(FatalError);
    }

    domain.bounds = makeSizeBounds(controls, time);

    if (controls.type == farFieldType::mesh)
    {
        log.begin("readMesh");
        domain.core = files.readCore(controls.region);
        log.end(name(domain.core.nCells) + " cells");

        return domain;
    }

    log.begin("farBoundary");
    domain.boundary = makeFarBoundary
    (
        controls.boundary,
        [&](const fileName& file) { return files.surfaceFile(file); }
    );

    string names(farBoundaryTypes[int(controls.boundary.type)]);
    for (const word& patch : domain.boundary.surface.patchNames)
    {
        names += ' ' + patch;
        requireNotOf(wall, patch);
    }
    log.end(names);

    return domain;
}

} // End namespace Foam

// ************************************************************************* //
