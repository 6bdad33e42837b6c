/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stackBoxes.H"
#include "HashSet.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

boundBox stackBoxes::boxOf(const label group) const
{
    boundBox box(boundBox::invertedBox);
    for (const label facei : faces(group))
    {
        box.add(Foam::boxOf(layers_, facei, 0));
        box.add(Foam::boxOf(layers_, facei, layers_.nLayers));
    }

    return box;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

stackBoxes::stackBoxes(const prismLayers& layers)
:
    layers_(layers),
    boxes_((layers.faces.size() + groupSize - 1)/groupSize)
{
    #pragma omp parallel for schedule(static)
    forAll(boxes_, group)
    {
        boxes_[group] = boxOf(group);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void stackBoxes::update(const labelUList& faces)
{
    labelHashSet groups;
    for (const label facei : faces)
    {
        groups.insert(facei/groupSize);
    }
    for (const label group : groups)
    {
        boxes_[group] = boxOf(group);
    }
}


labelRange stackBoxes::faces(const label group) const
{
    const label first = group*groupSize;

    return labelRange(first, min(groupSize, layers_.faces.size() - first));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

boundBox boxOf
(
    const prismLayers& layers,
    const label facei,
    const label level
)
{
    boundBox box(boundBox::invertedBox);
    for (const label c : layers.faces[facei])
    {
        box.add(layers(c, level));
    }

    return box;
}

} // End namespace Foam

// ************************************************************************* //
