/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "improveTets.H"
#include "farFieldMeshControls.H"
#include "stageProgress.H"
#include "tetImprover.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void improveTets(const neighbourCells& neighbours, farFieldTets& mesh)
{
    tetImprover improver(neighbours, mesh);
    const label maxPasses = farFieldTuned.maxPasses;
    label pass = 0;

    repeatUntilStable("improving tetrahedra", maxPasses, [&]()
    {
        tellProgress("improving tetrahedra, pass", ++pass, maxPasses);

        return improver.improve();
    });

    mesh.points = improver.points();
    mesh.tets = improver.tets().remaining();
    mesh.neighbours = improver.tets().remainingNeighbours();
}

} // End namespace Foam

// ************************************************************************* //
