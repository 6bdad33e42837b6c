/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "nameCauses.H"
#include "stackHeights.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What a column, and a first layer, has of the request at least without cause
static const scalar fullShare = 0.95;
static const scalar fullFirstShare = 0.99;

//- Cosine of the half-angle of a cone from which visibility is the cause
static const scalar narrowCosine = 0.5;


//- Why a column of full room is low, if it is
static squeezeCause causeOfLow
(
    const layerFront& front,
    const layerSpacing& graded,
    const prismLayers& layers,
    const layerColumns& columns,
    const label c
)
{
    const label n = layers.nLayers;
    const scalar asked = graded.thickness[c];
    const scalar height =
        front.visibility.heightCosine(c, layers(c, n) - layers(c, 0));

    return height >= fullShare*asked ? squeezeCause::none
      : isStretched(front.visibility, c, columns.stretch(c, asked))
      ? squeezeCause::stretch
      : columns.lengthFactors[(c + 1)*n - 1] < fullShare
      ? squeezeCause::neighbour
      : squeezeCause::validity;
}


//- Columns of faces whose first layer is too low, where none has a cause
static labelList lowFirst
(
    const layerFront& front,
    const layerSpacing& graded,
    const prismLayers& layers,
    const layerColumns& columns
)
{
    stackHeights stack(layers);
    DynamicList<label> low;

    for (label facei = 0; facei < front.nWallFaces; ++facei)
    {
        const face& f = layers.faces[facei];
        const bool without = std::all_of
        (
            f.begin(),
            f.end(),
            [&](const label c)
            {
                return columns.causes[c] == squeezeCause::none;
            }
        );
        stack.compute(facei, 1);

        if
        (
            without
         && stack.heights()[0]
          < fullFirstShare*average(scalarField(graded.firstThickness, f))
        )
        {
            low.append(f);
        }
    }

    return labelList(std::move(low));
}


static bool isHollow(const pointKind kind)
{
    return kind == pointKind::concave || kind == pointKind::saddle;
}


//- What it is that does not let the cells be positive
static squeezeCause causeOfInvalid
(
    const layerFront& front,
    const List<pointKind>& kinds,
    const label c
)
{
    bool hollow = isHollow(kinds[front.wallPoints[c]]);

    for (const label q : front.addressing.pointPoints[c])
    {
        hollow = hollow || isHollow(kinds[front.wallPoints[q]]);
    }

    return hollow ? squeezeCause::concaveCorner
      : front.visibility.cones[c].cosine < narrowCosine
      ? squeezeCause::visibility
      : squeezeCause::validity;
}


static bool isLower
(
    const layerSpacing& asked,
    const layerSpacing& graded,
    const label c
)
{
    return graded.thickness[c] < asked.thickness[c]
        || graded.firstThickness[c] < asked.firstThickness[c];
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::nameCauses
(
    const layerFront& front,
    const List<pointKind>& kinds,
    const layerSpacing& asked,
    const layerSpacing& graded,
    const prismLayers& layers,
    layerColumns& columns
)
{
    List<squeezeCause>& causes = columns.causes;

    forAll(causes, c)
    {
        if (causes[c] == squeezeCause::none)
        {
            causes[c] = causeOfLow(front, graded, layers, columns, c);
        }
    }

    for (const label c : lowFirst(front, graded, layers, columns))
    {
        causes[c] = squeezeCause::validity;
    }

    forAll(causes, c)
    {
        if (causes[c] == squeezeCause::validity)
        {
            causes[c] = causeOfInvalid(front, kinds, c);
        }
        else if
        (
            causes[c] == squeezeCause::none && isLower(asked, graded, c)
        )
        {
            causes[c] = squeezeCause::transition;
        }
    }
}


// ************************************************************************* //
