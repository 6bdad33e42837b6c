/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerColumns.H"
#include "columnControls.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar layerColumns::stretch(const label c, const scalar height) const
{
    // The length is height*(maxStretch + ...), which always grows with it
    const scalar excess =
        max(columnControls::nearWallStretch - maxStretch, scalar(0));
    const scalar halfWay = columnControls::nearWallHeight*edgeLengths[c];

    return maxStretch + excess/(1 + height/halfWay);
}


vector layerColumns::axisOffset
(
    const wallVisibility& visibility,
    const label c,
    const scalar height
) const
{
    const vector& axis = visibility.cones[c].axis;

    return axis/max(visibility.heightCosine(c, axis), 1/stretch(c, height));
}


layerColumns layerColumns::at(const labelUList& columns) const
{
    layerColumns result;
    result.nLayers = nLayers;
    result.heights.setSize(columns.size()*nLayers);
    result.offsets.setSize(columns.size()*nLayers);
    forAll(columns, c)
    {
        const label from = columns[c]*nLayers;
        SubList<scalar>(result.heights, nLayers, c*nLayers) =
            SubList<scalar>(heights, nLayers, from);
        SubList<vector>(result.offsets, nLayers, c*nLayers) =
            SubList<vector>(offsets, nLayers, from);
    }
    result.maxThickness = scalarField(maxThickness, columns);
    result.causes = List<squeezeCause>
    (
        UIndirectList<squeezeCause>(causes, columns)
    );
    result.edgeLengths = scalarField(edgeLengths, columns);
    result.maxStretch = maxStretch;
    result.onLevelSets = onLevelSets;

    return result;
}


label layerColumns::layerAt(const label c, const scalar height) const
{
    const scalar* first = heights.cdata() + c*nLayers;

    return std::lower_bound(first, first + nLayers, height) - first;
}


vector layerColumns::interpolated
(
    const vectorField& values,
    const label c,
    const scalar height
) const
{
    const scalar* first = heights.cdata() + c*nLayers;
    const label i = layerAt(c, height);

    if (i == 0 || i == nLayers)
    {
        return values[c*nLayers + max(i - 1, 0)];
    }

    const scalar s = (height - first[i - 1])/(first[i] - first[i - 1]);

    return (1 - s)*values[c*nLayers + i - 1] + s*values[c*nLayers + i];
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

vector columnOffset
(
    const wallVisibility& visibility,
    const label c,
    const vector& direction,
    const scalar stretch
)
{
    const vector& axis = visibility.cones[c].axis;
    vector d = visibility.limited
    (
        c, normalised(direction), columnControls::coneMargin
    );

    // Not so far over that the stretch would take height away
    const scalar smallest = min(1/stretch, visibility.heightCosine(c, axis));
    const scalar cosine = visibility.heightCosine(c, d);

    if (cosine < smallest)
    {
        const scalar s = (smallest - cosine)
           /max(visibility.heightCosine(c, axis) - cosine, VSMALL);
        d = normalised(d + min(s, scalar(1))*(axis - d));
    }

    return d/max(visibility.heightCosine(c, d), 1/stretch);
}


bool isStretched
(
    const wallVisibility& visibility,
    const label c,
    const scalar stretch
)
{
    return
        visibility.heightCosine(c, visibility.cones[c].axis)*stretch
      < 1 - SMALL;
}

} // End namespace Foam

// ************************************************************************* //
