/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismFaceLabels.H"
#include "UIndirectList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Sets the sides of a stack to the stacks of higher front faces, on both
static void setInternalSides
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const label facei,
    prismFaceLabels& labels
)
{
    label side = labels.firstFaces[facei];

    visitInternalFaces
    (
        1, faceNeighbours[facei], facei,
        [&](const label k, const label, const label other)
        {
            // The other runs along the edge the other way
            const label end = layers.faces[facei].nextLabel(k);
            const label otherEdge = layers.faces[other].find(end);

            labels.firstSides[facei][k] = side;
            labels.sideStrides[facei][k] = labels.strides[facei];
            labels.firstSides[other][otherEdge] = side;
            labels.sideStrides[other][otherEdge] = labels.strides[facei];
            ++side;
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label prismFaceLabels::operator()
(
    const label facei,
    const label k,
    const label i
) const
{
    if (k >= 0)
    {
        const label stride = sideStrides[facei][k];

        return firstSides[facei][k] + (i - 1)*stride
          + (stride > 1 && i < nLayers);
    }

    return
        i == 0 ? wallFaces[facei]
      : i == nLayers ? outerFaces[facei]
      : firstFaces[facei] + (i - 1)*strides[facei];
}


prismFaceLabels prismFaceLabels::subset(const labelUList& stacks) const
{
    const auto of = [&](const labelList& all)
    {
        return labelList(UIndirectList<label>(all, stacks));
    };
    const auto listsOf = [&](const labelListList& all)
    {
        return labelListList(UIndirectList<labelList>(all, stacks));
    };

    prismFaceLabels some;
    some.nLayers = nLayers;
    some.firstFaces = of(firstFaces);
    some.strides = of(strides);
    some.outerFaces = of(outerFaces);
    some.firstSides = listsOf(firstSides);
    some.sideStrides = listsOf(sideStrides);

    const label nWall = std::lower_bound
    (
        stacks.begin(), stacks.end(), wallFaces.size()
    ) - stacks.begin();
    some.wallFaces = labelList
    (
        UIndirectList<label>(wallFaces, SubList<label>(stacks, nWall))
    );

    return some;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismFaceLabels makePrismFaceLabels
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const UList<DynamicList<labelPair>>& open
)
{
    const label nFront = layers.faces.size();
    const label n = layers.nLayers;
    prismFaceLabels labels;
    labels.nLayers = n;
    labels.firstFaces = firstInternalFaces(faceNeighbours, n);
    label next = labels.firstFaces.last();
    labels.firstFaces.setSize(nFront);
    labels.strides.setSize(nFront);
    labels.wallFaces.setSize(layers.nWallFaces());
    labels.outerFaces.setSize(nFront);

    // As many as there are edges; all are set
    labels.firstSides = faceNeighbours;
    labels.sideStrides = faceNeighbours;

    forAll(labels.strides, facei)
    {
        labels.strides[facei] =
            1 + nHigherNeighbours(faceNeighbours[facei], facei);
    }
    forAll(faceNeighbours, facei)
    {
        setInternalSides(layers, faceNeighbours, facei, labels);
    }

    for (const auto& patch : boundaryFaces(layers, open))
    {
        for (const prismFaceKey& f : patch)
        {
            if (f.edge < 0)
            {
                (f.level ? labels.outerFaces : labels.wallFaces)[f.front] =
                    next;
            }
            else if (f.level == 1)
            {
                labels.firstSides[f.front][f.edge] = next;
                labels.sideStrides[f.front][f.edge] = 1;
            }
            ++next;
        }
    }

    return labels;
}

} // End namespace Foam

// ************************************************************************* //
