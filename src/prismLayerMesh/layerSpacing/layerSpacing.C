/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "layerSpacing.H"
#include "limitGradient.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::layerSpacing Foam::layerSpacing::at(const labelUList& points) const
{
    return layerSpacing
    {
        nLayers,
        scalarField(firstThickness, points),
        scalarField(ratio, points),
        scalarField(thickness, points),
        labelList(layersAsked, points)
    };
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::layerSpacing Foam::gradedSpacing
(
    const layerSpacing& asked,
    const wallAddressing& addressing,
    const scalar growth
)
{
    layerSpacing graded(asked);
    const label n = asked.nLayers;

    const labelList lower
    (
        limitRatio(addressing, growth, graded.firstThickness)
    );
    const labelList thinner(limitRatio(addressing, growth, graded.thickness));

    for (const labelList* points : {&lower, &thinner})
    {
        for (const label p : *points)
        {
            if (n > 1)
            {
                graded.ratio[p] = fittedRatio
                (
                    n, graded.firstThickness[p], graded.thickness[p]
                );
            }
        }
    }

    return graded;
}


Foam::scalarField Foam::requestedHeights(const layerSpacing& spacing)
{
    const label n = spacing.nLayers;
    scalarField heights(spacing.thickness.size()*n);
    scalarList column(n + 1);

    forAll(spacing.thickness, p)
    {
        layerHeights
        (
            n,
            spacing.firstThickness[p],
            spacing.ratio[p],
            spacing.thickness[p],
            column
        );
        std::copy(column.begin() + 1, column.end(), heights.begin() + p*n);
    }

    return heights;
}


// ************************************************************************* //
