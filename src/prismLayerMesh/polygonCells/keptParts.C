/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "keptParts.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether the next mesh has a point inside of an edge of a front face, because
//  the face beyond is divided there
static bool isDivided
(
    const prismLayers& layers,
    const frontGroups& front,
    const groupExceptions& exceptions,
    const edge& e,
    const label beyond
)
{
    if (beyond < 0 || exceptions.whole.test(beyond))
    {
        return false;
    }
    const face& f = layers.faces[beyond];
    const label first = front.starts[beyond] + f.find(e.first());
    const label second = front.starts[beyond] + f.find(e.second());

    return
        exceptions.part(first) >= 0 || exceptions.part(second) >= 0
     || front.groups[first] != front.groups[second];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

givenPoints::givenPoints
(
    const cornerPoints& points,
    const labelUList& labels,
    const polyMeshParts& mesh,
    const labelUList& cells
)
{
    const polyMeshTopology& t = mesh.topology;
    bitSet isCell(mesh.nCells);
    isCell.set(cells);
    forAll(t.faces, facei)
    {
        if (!isCell.test(t.owner[facei]) && !isCell.test(t.beyond(facei)))
        {
            continue;
        }
        for (const label p : t.faces[facei])
        {
            const label i = labels[p];
            if (points.isGiven(i) && points.columnOf(i) >= 0)
            {
                columns.set(points.columnOf(i));
            }
            if (points.isGiven(i) && points.farPointOf(i) >= 0)
            {
                farPoints.set(points.farPointOf(i));
            }
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void keepNeighbours
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const frontGroups& front,
    groupExceptions& exceptions
)
{
    DynamicList<label> waiting(exceptions.whole.toc());
    while (waiting.size())
    {
        const label facei = waiting.remove();
        const face& f = layers.faces[facei];
        label n = 0, last = -1;
        forAll(f, k)
        {
            const label other = faceNeighbours[facei][k];
            const edge e(f[k], f.nextLabel(k));
            if (isDivided(layers, front, exceptions, e, other))
            {
                ++n;
                last = other;
            }
        }
        if (n != 1 || f.size() != 3)
        {
            continue;
        }

        // Faces beside it have one point less
        exceptions.whole.set(last);
        waiting.append(last);
        for (const label beside : faceNeighbours[last])
        {
            if (beside >= 0 && exceptions.whole.test(beside))
            {
                waiting.append(beside);
            }
        }
    }
}


labelList withoutKept
(
    const labelUList& cells,
    const prismLayers& layers,
    const frontGroups& front,
    const bitSet& whole,
    const scalarField& volumes
)
{
    bitSet isKept(front.nGroups);
    for (const label facei : whole)
    {
        isKept.set(front.of(facei, 0));
    }
    DynamicList<label> others;
    for (const label celli : cells)
    {
        const label group = celli/max(layers.nLayers, label(1));
        const bool stays =
            group < front.nGroups && volumes[celli] > 0 && isKept.test(group);
        if (!stays)
        {
            others.append(celli);
        }
    }

    return labelList(std::move(others));
}

} // End namespace Foam

// ************************************************************************* //
