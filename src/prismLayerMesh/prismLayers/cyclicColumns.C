/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicColumns.H"
#include "boundBox.H"

namespace Foam
{

//- Rounding of the coordinates of an image, over the size of the layers
static const scalar imageRounding = 1e-12;


Map<label> imagesOfColumns(const prismLayers& layers, const sidePair& pair)
{
    const labelList first(layers.border.pointsOn(pair.first));
    const labelList second(layers.border.pointsOn(pair.second));
    const label n = layers.nLayers;
    const auto topsOf = [&](const labelUList& columns)
    {
        pointField tops(columns.size());
        forAll(columns, i)
        {
            tops[i] = layers(columns[i], n);
        }

        return tops;
    };
    const labelList places
    (
        imagesAmong
        (
            topsOf(second), topsOf(first), pair.toSecond,
            imageRounding*boundBox(layers.points, false).mag()
        )
    );

    Map<label> images(2*first.size());
    forAll(first, i)
    {
        if (places[i] < 0 || first.size() != second.size())
        {
            FatalErrorInFunction
                << "The column at " << layers(first[i], 0)
                << " on the cyclic side patch "
                << layers.border.sides[pair.first].name << " has no image on "
                << layers.border.sides[pair.second].name << exit(FatalError);
        }
        images.insert(first[i], second[places[i]]);
    }

    return images;
}

} // End namespace Foam

// ************************************************************************* //
