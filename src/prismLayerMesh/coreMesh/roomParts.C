/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "roomParts.H"
#include "bitSet.H"
#include "disjointSets.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

roomParts::roomParts(const polyMeshParts& core, const coreCut& cut)
:
    core_(core),
    room_(cut.room),
    parts_(core.nCells, -1)
{
    bitSet makesRoom(core.nCells);
    makesRoom.set(room_);
    const polyMeshTopology& t = core.topology;
    disjointSets together(core.nCells);
    forAll(t.neighbour, facei)
    {
        const label own = t.owner[facei];
        const label nei = t.neighbour[facei];
        if (makesRoom.test(own) && makesRoom.test(nei))
        {
            together.join(own, nei);
        }
    }

    for (const label celli : room_)
    {
        parts_[celli] = together.find(celli);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label roomParts::across(const label facei, const label celli) const
{
    const polyMeshTopology& t = core_.topology;

    return parts_
    [
        t.owner[facei] == celli ? t.neighbour[facei] : t.owner[facei]
    ];
}


label roomParts::nearest(const point& x) const
{
    pointField centres;
    scalarField volumes;
    setCentresAndVolumes(core_, room_, centres, volumes);

    return room_.empty() ? -1 : parts_[room_[findMin(magSqr(centres - x)())]];
}


labelHashSet roomParts::partsIn(const cellZoneParts& zone) const
{
    bitSet isIn(core_.nCells);
    isIn.set(zone.cells);
    labelHashSet parts;
    for (const label celli : room_)
    {
        parts.insert(parts_[celli]);
    }
    for (const label celli : room_)
    {
        if (!isIn.test(celli))
        {
            parts.erase(parts_[celli]);
        }
    }

    return parts;
}


label roomParts::nElsewhere(const cellZoneParts& zone) const
{
    const labelHashSet parts(partsIn(zone));

    return countOf(zone.cells, [&](const label celli)
    {
        return parts_[celli] >= 0 && !parts.found(parts_[celli]);
    });
}

} // End namespace Foam

// ************************************************************************* //
