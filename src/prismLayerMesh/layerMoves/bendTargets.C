/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bendTargets.H"
#include "scaledJacobian.H"
#include "stackHeights.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bendTargets bendTargets::withMargins
(
    const layerMoveControls& controls,
    const scalarField& attainable
)
{
    const qualityControls& quality = controls.quality;

    bendTargets targets;
    targets.faces.cosine =
        Foam::cos(degToRad(quality.maxNonOrtho - controls.angleMargin));
    targets.faces.skewness = controls.skewnessShare*quality.maxInternalSkewness;
    targets.faces.planarity = controls.targetPlanarity;
    targets.jacobians =
        min(controls.targetJacobian, controls.jacobianShare*attainable);
    targets.firstHeightWeight = controls.firstHeightWeight;
    targets.thicknessWeight = controls.thicknessWeight;

    return targets;
}


bool bendTargets::missesJacobian
(
    const prismLayers& layers,
    const label facei
) const
{
    const scalar target = jacobian(facei);

    return target > 0 && worstJacobian(layers, facei, target) < target;
}


void bendTargets::keep(const layerEditor& editor, const labelUList& columns)
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

labelList stacksMissingTargets
(
    const prismLayers& layers,
    const layerGeometry& geometry,
    const labelUList& faces,
    const bendTargets& targets
)
{
    boolList missesTargets(faces.size());

    #pragma omp parallel for schedule(dynamic, 64) if (faces.size() > 64)
    forAll(faces, i)
    {
        missesTargets[i] =
            targets.missesJacobian(layers, faces[i])
         || geometry.violation(faces[i], targets.faces) > 0;
    }

    return subset(missesTargets, labelList(faces));
}

} // End namespace Foam

// ************************************************************************* //
