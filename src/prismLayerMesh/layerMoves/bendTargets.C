/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bendTargets.H"
#include "stackHeights.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bendTargets bendTargets::withMargins(const layerMoveControls& controls)
{
    const qualityControls& quality = controls.quality;

    bendTargets targets;
    targets.faces.cosine =
        Foam::cos(degToRad(quality.maxNonOrtho - controls.angleMargin));
    targets.faces.skewness = controls.skewnessShare*quality.maxInternalSkewness;
    targets.faces.planarity = controls.targetPlanarity;
    targets.firstHeightWeight = controls.firstHeightWeight;
    targets.thicknessWeight = controls.thicknessWeight;

    return targets;
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
    const layerGeometry& geometry,
    const labelUList& faces,
    const faceTargets& targets
)
{
    boolList missesTargets(faces.size());

    #pragma omp parallel for schedule(dynamic, 64) if (faces.size() > 64)
    forAll(faces, i)
    {
        missesTargets[i] = geometry.violation(faces[i], targets) > 0;
    }

    return subset(missesTargets, labelList(faces));
}

} // End namespace Foam

// ************************************************************************* //
