/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "turnColumns.H"
#include "HashSet.H"

namespace Foam
{

//- Directions [n] of columns, nearer to the mean of those around them
static List<vectorField> turnedDirections
(
    const layerEditor& editor,
    const labelUList& columns
)
{
    const label n = editor.spacing().nLayers;
    List<vectorField> directions(columns.size());

    #pragma omp parallel for schedule(static, 64) if (columns.size() > 64)
    forAll(columns, k)
    {
        const label c = columns[k];
        directions[k].setSize(n);

        for (label i = 1; i <= n; ++i)
        {
            const vector own(editor.offset(c, i));
            const scalar share =
                editor.controls().turnShare*editor.turnShare(c, i);

            directions[k][i - 1] =
                own + share*(editor.neighboursOffset(c, i) - own);
        }
    }

    return directions;
}


bool turnColumns
(
    layerEditor& editor,
    const labelUList& columns,
    labelList& nTurns
)
{
    const layerMoveControls& controls = editor.controls();
    const columnTeam& team = editor.team();
    const labelList own(team.ownOf(columns));
    boolList mayTurn(nTurns.size(), false);
    for (const label c : own)
    {
        mayTurn[c] = nTurns[c] < controls.maxTurns;
    }

    if (!team.any(mayTurn.found(true)))
    {
        return false;
    }

    // With the neighbours of those that may, also of copies
    team.columns.update(mayTurn);
    labelHashSet all(own);
    for (const label c : findIndices(mayTurn, true))
    {
        all.insert(editor.front().addressing.pointPoints[c]);
    }

    const labelList turning(team.ownOf(all.sortedToc()));
    const List<vectorField> directions(turnedDirections(editor, turning));

    for (const label c : turning)
    {
        ++nTurns[c];
        editor.remember(c);
    }

    #pragma omp parallel for schedule(static, 64) if (turning.size() > 64)
    forAll(turning, k)
    {
        const label c = turning[k];
        editor.setDirections(c, editor.state(c), directions[k]);
    }

    for (const label c : turning)
    {
        editor.touch(c);
    }
    editor.publish(turning);

    return true;
}

} // End namespace Foam

// ************************************************************************* //
