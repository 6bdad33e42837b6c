/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "retreatColumns.H"
#include "HashSet.H"
#include "limitGradient.H"
#include "scaledJacobian.H"

namespace Foam
{

void retreatColumns
(
    layerEditor& editor,
    const labelUList& columns,
    const squeezeCause cause
)
{
    const layerFront& front = editor.front();
    const layerMoveControls& controls = editor.controls();
    Map<scalar> thickness;

    for (const label c : columns)
    {
        if (!editor.isFixed(c))
        {
            thickness.insert(c, controls.retreatFactor*editor.thickness()[c]);
        }
    }
    const labelHashSet retreating(thickness.toc());
    followGradient
    (
        front.surface, front.addressing, layerColumns::maxSlope,
        editor.thickness(), thickness
    );

    const labelList lowered(thickness.sortedToc());
    for (const label c : lowered)
    {
        editor.remember(c);
    }

    #pragma omp parallel for schedule(static, 64) if (lowered.size() > 128)
    forAll(lowered, i)
    {
        const label c = lowered[i];
        editor.setThickness
        (
            c, thickness[c],
            retreating.found(c) ? controls.straightenShare : 0
        );
    }

    for (const label c : lowered)
    {
        if (retreating.found(c))
        {
            editor.setCause(c, cause);
        }
        else if (editor.causes()[c] == squeezeCause::none)
        {
            editor.setCause(c, squeezeCause::neighbour);
        }
        editor.touch(c);
    }
}


scalar jacobianOfRetreat(layerEditor& editor, const label facei, const label c)
{
    const layerMoveControls& controls = editor.controls();
    const columnState before(editor.state(c));

    editor.setThickness
    (
        c, controls.retreatFactor*before.thickness, controls.straightenShare
    );
    const scalar worst = worstJacobian(editor.layers(), facei);
    editor.restore(c, before);

    return worst;
}

} // End namespace Foam

// ************************************************************************* //
