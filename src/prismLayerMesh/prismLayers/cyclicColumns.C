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
    label lone;
    Map<label> images
    (
        imagesByLabel
        (
            layers.border.pointsOn(pair.first),
            layers.border.pointsOn(pair.second),
            [&](const label c) { return layers(c, layers.nLayers); },
            pair.toSecond, imageRounding*boundBox(layers.points, false).mag(),
            lone
        )
    );
    if (lone >= 0)
    {
        FatalErrorInFunction
            << "The column at " << layers(lone, 0)
            << " on the cyclic side patch "
            << layers.border.sides[pair.first].name << " has no image on "
            << layers.border.sides[pair.second].name << nl
            << "The wall must be the same on both" << exit(FatalError);
    }

    return images;
}

} // End namespace Foam

// ************************************************************************* //
