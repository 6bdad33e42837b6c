/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "divideMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Divides the cells of a mesh, each of them a part, so that stacks stay whole
static labelList divideStacks
(
    const stackedMesh& mesh,
    const meshParts& cells,
    const meshDivision& divide
)
{
    const label nCells = cells.centres.size();
    meshParts parts;
    parts.neighbours.setSize(mesh.partOf(nCells));
    parts.centres.setSize(parts.neighbours.size(), Zero);
    parts.weights.setSize(parts.neighbours.size(), 0);
    for (label celli = 0; celli < nCells; ++celli)
    {
        const label part = mesh.partOf(celli);
        parts.centres[part] += cells.centres[celli];
        parts.weights[part] += 1;
        for (const label beside : cells.neighbours[celli])
        {
            const label other = mesh.partOf(beside);
            if (other != part && !parts.neighbours[part].found(other))
            {
                parts.neighbours[part].append(other);
            }
        }
    }
    parts.centres /= parts.weights;

    const labelList ofParts(divide(parts));
    labelList processes(nCells);
    forAll(processes, celli)
    {
        processes[celli] = ofParts[mesh.partOf(celli)];
    }

    return processes;
}


//- Returns a mesh as a far field without layers
static farFieldMesh withoutLayers(polyMeshParts&& mesh)
{
    farFieldMesh far;
    static_cast<polyMeshParts&>(far) = std::move(mesh);
    labelList starts({far.topology.neighbour.size()});
    labelList sizes({0});
    starts.append(far.topology.patchStarts);
    sizes.append(far.topology.patchSizes);
    far.topology.patchStarts = starts;
    far.topology.patchSizes = sizes;

    return far;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

meshPiece makeMeshPiece
(
    stackedMesh&& mesh,
    const processTeam& processes,
    const meshDivision& divide
)
{
    farFieldMesh whole;
    if (processes.isMaster())
    {
        whole = withoutLayers(std::move(mesh.mesh));
    }
    prismLayers none;
    none.nLayers = 1;
    shareLabels share;
    for (sharedLabels* labels : {&share.columns, &share.points, &share.faces})
    {
        labels->sent.setSize(processes.size());
        labels->received.setSize(processes.size());
    }

    return makeMeshPiece
    (
        none, columnTeam(share, processes), none, whole,
        [&](const meshParts& cells)
        {
            return divideStacks(mesh, cells, divide);
        }
    );
}

} // End namespace Foam

// ************************************************************************* //
