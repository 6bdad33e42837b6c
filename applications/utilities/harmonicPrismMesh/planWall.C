/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planWall.H"
#include "meshPlan.H"
#include "meshWall.H"

#include <omp.h>

namespace Foam
{

void planWall
(
    const prismCase& files,
    const caseWall& given,
    const prismLayerControls& controls,
    stageLog& log
)
{
    const wallSurface& wall = given.prepared.wall;
    const caseSources sources(files.sources());
    const localHeights local
    (
        readLocal(sources, wall, controls, log.observer())
    );
    const farFieldDomain domain
    (
        readDomain
        (
            sources, wall, given.prepared.far, controls.surface.fluidOutside,
            controls.farField, log.observer()
        )
    );
    const meshPlan plan
    (
        makeMeshPlan
        (
            wall, controls, local, domain, omp_get_max_threads(),
            log.observer()
        )
    );
    Info<< nl << describe(plan, controls.farField).c_str()
        << "Nothing was written" << nl << endl;
}

} // End namespace Foam

// ************************************************************************* //
