/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreNotes.H"
#include "ranges.H"
#include "roomParts.H"

#include <cmath>
#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
