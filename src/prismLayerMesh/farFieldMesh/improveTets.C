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
    bool better = true;

    for (label pass = 0; better && pass < farFieldTuned.maxPasses; ++pass)
    {
        tellProgress
        (
            "improving tetrahedra, pass", pass + 1, farFieldTuned.maxPasses
        );
        better = improver.improve();
    }

    mesh.points = improver.points();
    mesh.tets = improver.tets().remaining();
    mesh.neighbours = improver.tets().remainingNeighbours();
}

} // End namespace Foam

// ************************************************************************* //
