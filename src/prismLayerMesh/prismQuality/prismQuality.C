/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "layerCell.H"
#include "prismQuality.H"
#include "stackHeights.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Lowest layer of the stack whose cell is not positive, or 0
static label lowestInvalidLayer(const prismLayers& layers, const label facei)
{
    for (label i = 1; i <= layers.nLayers; ++i)
    {
        if (!isPositive(layers, facei, i))
        {
            return i;
        }
    }

    return 0;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::scaledJacobian
(
    const prismLayers& layers,
    const label facei,
    const label i
)
{
    const layerCell cell(layers, facei, i);
    const label n = cell.size();
    const bool hasLower = i > 1 || facei < layers.nWallFaces();

    vector lowerBefore(cell.lower(0) - cell.lower(n - 1));
    vector upperBefore(cell.upper(0) - cell.upper(n - 1));
    scalar lowerLength = mag(lowerBefore);
    scalar upperLength = mag(upperBefore);

    scalar worst = GREAT;

    for (label k = 0; k < n; ++k)
    {
        const label next = k + 1 < n ? k + 1 : 0;

        const vector lower(cell.lower(next) - cell.lower(k));
        const vector upper(cell.upper(next) - cell.upper(k));
        const vector side(cell.upper(k) - cell.lower(k));

        const scalar lowerLengthBefore = lowerLength;
        const scalar upperLengthBefore = upperLength;
        lowerLength = mag(lower);
        upperLength = mag(upper);
        const scalar sideLength = mag(side);

        if (hasLower)
        {
            worst = min
            (
                worst,
                ((lowerBefore ^ lower) & side)
               /max(lowerLengthBefore*lowerLength*sideLength, VSMALL)
            );
        }
        worst = min
        (
            worst,
            ((upperBefore ^ upper) & side)
           /max(upperLengthBefore*upperLength*sideLength, VSMALL)
        );

        lowerBefore = lower;
        upperBefore = upper;
    }

    return worst;
}


Foam::List<Foam::labelPair> Foam::findInvalidStacks(const prismLayers& layers)
{
    return findInvalidStacks(layers, identity(layers.faces.size()));
}


Foam::List<Foam::labelPair> Foam::findInvalidStacks
(
    const prismLayers& layers,
    const labelUList& candidates
)
{
    DynamicList<labelPair> invalid;

    for (const label facei : candidates)
    {
        const label i = lowestInvalidLayer(layers, facei);

        if (i)
        {
            invalid.append(labelPair(facei, i));
        }
    }

    sort(invalid);

    return List<labelPair>(std::move(invalid));
}


Foam::layerCertificate Foam::certify(const prismLayers& layers)
{
    layerCertificate certificate;
    certificate.nCells = layers.faces.size()*layers.nLayers;
    certificate.worstJacobian.setSize(layers.faces.size());

    stackHeights stack(layers);

    forAll(layers.faces, facei)
    {
        scalar worst = GREAT;
        stack.compute(facei);

        for (label i = 1; i <= layers.nLayers; ++i)
        {
            worst = min(worst, scaledJacobian(layers, facei, i));
            certificate.nInvalidCells +=
                !isPositive(layers, facei, i) || stack.heights()[i - 1] <= 0;
        }

        certificate.worstJacobian[facei] = worst;
    }

    certificate.nIntersectingPairs = findIntersections(layers).size();

    return certificate;
}


// ************************************************************************* //
