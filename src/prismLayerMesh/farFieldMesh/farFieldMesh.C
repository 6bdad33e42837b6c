/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldMesh.H"
#include "error.H"
#include "surfaceMeasures.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void farFieldMesh::keepPatches(const labelUList& kept)
{
    meshPatches keptPatches;
    labelList starts(1, topology.patchStarts[0]);
    labelList sizes(1, topology.patchSizes[0]);
    for (const label patchi : kept)
    {
        keptPatches.names.append(patches.names[patchi]);
        keptPatches.entries.append(patches.entries[patchi]);
        starts.append(topology.patchStarts[1 + patchi]);
        sizes.append(topology.patchSizes[1 + patchi]);
    }

    patches = keptPatches;
    topology.patchStarts = starts;
    topology.patchSizes = sizes;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void requireVolumes(const farFieldMesh& far, const label nCells)
{
    const polyMeshTopology& t = far.topology;
    scalarField volumes(far.nCells, 0), areas(far.nCells, 0);
    List<boundBox> boxes(far.nCells, boundBox(boundBox::invertedBox));
    labelList apex(far.nCells, -1);
    const auto add = [&](const label celli, const face& f, const scalar way)
    {
        apex[celli] = apex[celli] < 0 ? f[0] : apex[celli];
        const vector area(f.areaNormal(far.points));
        const vector height(f.centre(far.points) - far.points[apex[celli]]);
        volumes[celli] += way*(area & height)/3;
        areas[celli] += mag(area);
        for (const label p : f)
        {
            boxes[celli].add(far.points[p]);
        }
    };
    forAll(t.faces, facei)
    {
        add(t.owner[facei], t.faces[facei], 1);
        if (facei < t.neighbour.size())
        {
            add(t.neighbour[facei], t.faces[facei], -1);
        }
    }

    for (label celli = 0; celli < nCells; ++celli)
    {
        if (volumes[celli] <= roundingVolume(boxes[celli], areas[celli]))
        {
            FatalErrorInFunction
                << "A cell of the far field at " << far.points[apex[celli]]
                << " is flat but for rounding" << nl
                << "Change farField.growthRate or maxCellSize a little, or"
                << " remesh the surface there" << exit(FatalError);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
