/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bendAims.H"
#include "stackHeights.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bendAims bendAims::withMargins(const layerMoveControls& controls)
{
    const qualityControls& quality = controls.quality;

    bendAims aims;
    aims.faces.cosine =
        Foam::cos(degToRad(quality.maxNonOrtho - controls.angleMargin));
    aims.faces.skewness = controls.skewnessShare*quality.maxInternalSkewness;
    aims.faces.planarity = controls.aimedPlanarity;
    aims.firstHeightWeight = controls.firstHeightWeight;
    aims.thicknessWeight = controls.thicknessWeight;

    return aims;
}


void bendAims::hold(const layerEditor& editor, const labelUList& columns)
{
    const labelListList& pointFaces = editor.front().addressing.pointFaces;
    stackHeights stack(editor.layers());

    for (const label c : columns)
    {
        if (places.insert(c, pointField()))
        {
            places[c] = editor.state(c).points;
        }

        for (const label facei : pointFaces[c])
        {
            if
            (
                heights.insert(facei, scalarField())
             && facei < editor.front().nWallFaces
            )
            {
                stack.compute(facei);
                heights[facei] = stack.heights();
            }
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList poorStacks
(
    const layerGeometry& geometry,
    const labelUList& faces,
    const faceAims& aims
)
{
    boolList isPoor(faces.size());

    #pragma omp parallel for schedule(dynamic, 64) if (faces.size() > 64)
    forAll(faces, i)
    {
        isPoor[i] = geometry.lack(faces[i], aims) > 0;
    }

    return subset(isPoor, labelList(faces));
}

} // End namespace Foam

// ************************************************************************* //
