/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreCellZones.H"
#include "disjointSets.H"
#include "roomParts.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The part of the room that each tetrahedron is in, or -1
static labelList roomsOf
(
    const farFieldTets& tets,
    const coreCut& cut,
    const boundaryTets& boundary,
    const roomParts& room
)
{
    disjointSets together(tets.tets.size());
    forAll(tets.tets, t)
    {
        for (const label neighbour : tets.neighbours[t])
        {
            if (neighbour > t)
            {
                together.join(t, neighbour);
            }
        }
    }

    labelList rooms(tets.tets.size(), -1);
    forAll(boundary.onCut, i)
    {
        rooms[together.find(boundary.onCut[i])] =
            room.across(tets.cutFaces[i], tets.cutCells[i]);
    }

    // The patches of the core follow other triangles
    const label first = boundary.onPatches.size() - cut.nBoundary;
    for (label i = 0; i < cut.nBoundary; ++i)
    {
        rooms[together.find(boundary.onPatches[first + i])] =
            room.at(cut.boundaryFaces[i]);
    }
    forAll(rooms, t)
    {
        // Layers may be all around a part, as in a cavity
        const label first = together.find(t);
        if (first == t && rooms[t] < 0)
        {
            rooms[t] = room.nearest(tets.tets[t].tet(tets.points).centre());
        }
        rooms[t] = rooms[first];
    }

    return rooms;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<cellZoneParts> coreCellZones
(
    const farFieldTets& tets,
    const polyMeshParts& core,
    const coreCut& cut,
    const boundaryTets& boundary
)
{
    List<cellZoneParts> zones(core.cellZones.size());
    if (zones.empty())
    {
        return zones;
    }

    const label nTets = tets.tets.size();
    const labelList newCells(invert(core.nCells, cut.cells));
    const roomParts room(core, cut);
    const labelList rooms(roomsOf(tets, cut, boundary, room));

    forAll(zones, i)
    {
        const cellZoneParts& zone = core.cellZones[i];
        const labelHashSet parts(room.partsIn(zone));
        DynamicList<label> cells;
        for (label t = 0; t < nTets; ++t)
        {
            if (parts.found(rooms[t]))
            {
                cells.append(t);
            }
        }
        for (const label celli : zone.cells)
        {
            if (newCells[celli] >= 0)
            {
                cells.append(nTets + newCells[celli]);
            }
        }
        zones[i] = cellZoneParts(zone.name, cells);

        labelHashSet front;
        forAll(boundary.onLayers, k)
        {
            if (parts.found(rooms[boundary.onLayers[k]]))
            {
                front.insert(tets.outerFaces[k]);
            }
        }
        zones[i].frontFaces = front.sortedToc();
    }

    return zones;
}

} // End namespace Foam

// ************************************************************************* //
