/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "makePrismLayers.H"
#include "certifyLayers.H"
#include "improveLayers.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::madeLayers Foam::makePrismLayers
(
    const layerFront& front,
    const layerSpacing& spacing,
    const layerColumns& columns,
    const layerMoveControls& controls
)
{
    layerEditor editor(front, spacing, columns, controls);
    layerJudge judge
    (
        editor.layers(), front.surface, front.visibility, controls
    );

    madeLayers made;
    made.nRetreats = certifyLayers(editor, judge);
    improveLayers(editor, judge);

    made.thickness = editor.thickness();
    made.causes = editor.causes();
    made.layers = editor.release();

    return made;
}


// ************************************************************************* //
