/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "retreatColumns.H"
#include "scaledJacobian.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::retreatColumns
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


Foam::scalar Foam::jacobianOfRetreat
(
    layerEditor& editor,
    const label facei,
    const label c
)
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


// ************************************************************************* //
