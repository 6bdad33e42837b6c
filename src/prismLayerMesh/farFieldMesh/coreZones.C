/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreZones.H"
#include "cutCore.H"
#include "disjointSets.H"
#include "ranges.H"

#include <cmath>
#include <sstream>

namespace Foam
{

List<faceZoneParts> coreFaceZones
(
    const polyMeshParts& core,
    const labelUList& cells,
    const labelUList& faces,
    const Map<DynamicList<label>>& cutFaces
)
{
    DynamicList<faceZoneParts> zones;
    for (const faceZoneParts& zone : core.faceZones)
    {
        DynamicList<label> zoneFaces;
        DynamicList<bool> flips;
        forAll(zone.faces, i)
        {
            const label facei = zone.faces[i];
            if (faces[facei] >= 0)
            {
                zoneFaces.append(faces[facei]);
                flips.append(zone.flips[i]);
            }

            // Triangles of the cut point from tetrahedra to the cell that stays
            const bool turned = cells[core.topology.owner[facei]] >= 0;
            const labelList triangles
            (
                cutFaces.found(facei) ? labelList(cutFaces[facei]) : labelList()
            );
            zoneFaces.append(triangles);
            flips.append(boolList(triangles.size(), zone.flips[i] != turned));
        }
        zones.append({zone.name, zoneFaces, flips});
    }

    return List<faceZoneParts>(std::move(zones));
}


// * * * * * * * * * * * * * *  Core Cell Zones  * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * *  Core Notes * * * * * * * * * * * * * * * * //

static void addWidths
(
    const coreCut& cut,
    const std::function<scalar(const point&)>& size,
    DynamicList<string>& notes
)
{
    if (cut.cutBoxes.empty())
    {
        return;
    }

    scalarField ratios(cut.cutBoxes.size());
    scalar flattest = 1;
    forAll(ratios, i)
    {
        const boundBox& box = cut.cutBoxes[i];
        ratios[i] = cmptMax(box.span())/size(box.midpoint());
        flattest = max(flattest, cmptMax(box.span())/cmptMin(box.span()));
    }

    const scalar middle = medianOf(ratios);
    std::ostringstream text;
    text.precision(3);
    text<< "cells at the cut " << ratios.size() << "; width over the size that"
        << " grows from the layers: median " << middle << ", largest "
        << max(ratios);
    notes.append(text.str());

    // With twice the width faces are as poor as with half of the gap
    if (middle > 2)
    {
        notes.append
        (
            "Advice: refine the mesh there by "
          + name(label(std::ceil(std::log2(middle/1.2))))
          + " levels, or make the triangles of the wall larger"
        );
    }
    if (flattest > 2)
    {
        std::ostringstream advice;
        advice.precision(3);
        advice
            << "Advice: cells at the cut are up to " << flattest
            << " times as long as they are wide. Make them less than 2 times as"
            << " long: faces beside longer cells are poor";
        notes.append(advice.str());
    }
}


//- Zones of some of the cells of a part of the room
static void addPartZones
(
    const polyMeshParts& core,
    const coreCut& cut,
    DynamicList<string>& notes
)
{
    if (core.cellZones.empty())
    {
        return;
    }

    const roomParts room(core, cut);
    for (const cellZoneParts& zone : core.cellZones)
    {
        const label n = room.nElsewhere(zone);

        if (n > 0)
        {
            notes.append
            (
                "The cellZone " + zone.name + " has lost " + name(n)
              + " cells. It had only a part of the room of these cells, so"
                " that the new layers and tetrahedra are not in it"
            );
        }
    }
}


static void addLostZones
(
    const polyMeshParts& core,
    const farFieldMesh& far,
    DynamicList<string>& notes
)
{
    const label firstZone = far.cellZones.size() - core.cellZones.size();

    forAll(core.cellZones, i)
    {
        const cellZoneParts& zone = core.cellZones[i];

        if (zone.cells.size() && far.cellZones[firstZone + i].cells.empty())
        {
            notes.append
            (
                "The cellZone " + zone.name + " has lost all its cells"
            );
        }
    }

    forAll(core.faceZones, i)
    {
        const faceZoneParts& zone = core.faceZones[i];

        if (zone.faces.size() && far.faceZones[i].faces.empty())
        {
            notes.append
            (
                "The faceZone " + zone.name + " has lost all its faces"
            );
        }
    }
}


DynamicList<string> coreNotes
(
    const polyMeshParts& core,
    const coreCut& cut,
    const farFieldMesh& far,
    const std::function<scalar(const point&)>& size
)
{
    DynamicList<string> notes;
    addWidths(cut, size, notes);

    forAll(core.patches.names, patchi)
    {
        const word& patch = core.patches.names[patchi];
        const label i = far.patches.names.find(patch);

        if
        (
            core.topology.patchSizes[patchi]
         && far.topology.patchSizes[1 + i] == 0
        )
        {
            notes.append
            (
                "The patch " + patch + " has lost all its faces"
              + (cut.wallPatches.found(patch) ? ": it lies on the wall" : "")
            );
        }
    }

    addPartZones(core, cut, notes);
    addLostZones(core, far, notes);

    return notes;
}

} // End namespace Foam

// ************************************************************************* //
