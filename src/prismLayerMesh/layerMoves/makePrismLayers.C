/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makePrismLayers.H"
#include "certifyLayers.H"
#include "improveLayers.H"

namespace Foam
{

madeLayers makePrismLayers
(
    const layerFront& front,
    const layerSpacing& spacing,
    const layerColumns& columns,
    const layerMoveControls& controls
)
{
    layerEditor editor(front, spacing, columns, controls, front.constraints);
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

} // End namespace Foam

// ************************************************************************* //
