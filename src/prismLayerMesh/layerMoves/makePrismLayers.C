/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makePrismLayers.H"
#include "improveLayers.H"

namespace Foam
{

madeLayers makePrismLayers
(
    const layerFront& front,
    const layerSpacing& spacing,
    const layerColumns& columns,
    const layerMoveControls& controls,
    const columnTeam& team
)
{
    layerEditor editor
    (
        front, spacing, columns, controls, front.constraints, team
    );
    const layerJudge judge
    (
        editor.layers(), front.surface, front.visibility, controls, team
    );

    madeLayers made;
    made.certified = certifyLayers(editor, judge);
    if (made.certified.pointsWithoutHeight.size())
    {
        return made;
    }
    made.gaveWay = improveLayers(editor, judge, made.certified.tolerated);
    made.thickness = editor.thickness();
    made.causes = editor.causes();
    made.layers = editor.release();

    for (const label c : made.gaveWay)
    {
        const vector column
        (
            made.layers(c, spacing.nLayers) - made.layers(c, 0)
        );
        const scalar height = front.visibility.heightCosine(c, column);

        if (height < made.thickness[c])
        {
            made.thickness[c] = height;
            made.causes[c] = made.causes[c] == squeezeCause::none
              ? squeezeCause::quality : made.causes[c];
        }
    }

    team.columns.update(made.thickness);
    team.columns.update(made.causes);

    return made;
}

} // End namespace Foam

// ************************************************************************* //
