/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "retreatColumns.H"
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
    const layerMoveControls& controls = editor.controls();
    const labelList lowered
    (
        editor.lower(columns, controls.retreatFactor, controls.straightenShare)
    );

    for (const label c : columns)
    {
        editor.setCause(c, cause);
    }

    for (const label c : lowered)
    {
        if (editor.causes()[c] == squeezeCause::none)
        {
            editor.setCause(c, squeezeCause::neighbour);
        }
    }
}


scalar jacobianOfRetreat(layerEditor& editor, const label facei, const label c)
{
    const layerMoveControls& controls = editor.controls();
    const columnState before(editor.state(c));

    editor.setThickness
    (
        c,
        controls.retreatFactor*before.thickness,
        before.straightened
      + controls.straightenShare*(1 - before.straightened)
    );
    const scalar worst = worstJacobian(editor.layers(), facei);
    editor.restore(c, before);

    return worst;
}

} // End namespace Foam

// ************************************************************************* //
