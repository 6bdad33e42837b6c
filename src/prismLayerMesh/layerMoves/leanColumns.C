/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "leanColumns.H"
#include "HashSet.H"
#include "mathematicalConstants.H"

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


// * * * * * * * * * * * * * * *  Lean Columns * * * * * * * * * * * * * * * //

//- Directions [n] in which a column might stand
static List<vectorField> trialDirections
(
    const layerEditor& editor,
    const label c
)
{
    const layerMoveControls& controls = editor.controls();
    const label n = editor.spacing().nLayers;
    const vector& axis = editor.front().visibility.cones[c].axis;

    vectorField means(n), own(n);
    scalarField shares(n);
    for (label i = 0; i < n; ++i)
    {
        means[i] = editor.neighboursOffset(c, i + 1);
        own[i] = editor.offset(c, i + 1);
        shares[i] = editor.turnShare(c, i + 1);
    }

    DynamicList<vectorField> all;
    all.append(vectorField(n, axis));
    all.append(means);

    const vector across
    (
        mag(axis.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0)
    );
    const vector u(normalised(axis ^ across));
    const vector v(axis ^ u);

    for (const scalar size : {controls.leanSize/4, controls.leanSize})
    {
        for (label k = 0; k < controls.nLeanSides; ++k)
        {
            const scalar angle =
                constant::mathematical::twoPi*k/controls.nLeanSides;
            const vector side(size*(::cos(angle)*u + ::sin(angle)*v));

            all.append(vectorField(own + shares*side));
        }
    }

    return List<vectorField>(std::move(all));
}


//- Sum of the penalties on the faces around a column, up to where it is enough
static scalar penaltyAround
(
    const layerEditor& editor,
    const label c,
    const stackPenalty& penalty,
    const label lowest,
    const scalar enough
)
{
    const labelList& faces = editor.front().addressing.pointFaces[c];
    scalar sum = 0;

    for (label i = 0; i < faces.size() && sum < enough; ++i)
    {
        sum += penalty(faces[i], lowest, enough - sum);
    }

    return sum;
}


//- The best of the directions in which a column might stand, -1 if none has a
//  penalty below 'least'. The column is left in some of them.
static label bestOf
(
    layerEditor& editor,
    const label c,
    const columnState& before,
    const List<vectorField>& directions,
    const stackPenalty& penalty,
    scalar least
)
{
    // No column has a lower penalty than its outermost cells
    const label n = editor.spacing().nLayers;
    scalarField outermost(directions.size());
    forAll(directions, k)
    {
        editor.setDirections(c, before, directions[k], n);
        outermost[k] = penaltyAround(editor, c, penalty, n, least);
    }

    label best = -1;
    for (const label k : sortedOrder(outermost))
    {
        if (outermost[k] >= least)
        {
            break;
        }

        editor.setDirections(c, before, directions[k]);
        const scalar sum = penaltyAround(editor, c, penalty, 1, least);

        if (sum < least)
        {
            least = sum;
            best = k;
        }
    }

    return best;
}


//- Lean one column. False if it stays.
static bool lean
(
    layerEditor& editor,
    const label c,
    const stackPenalty& penalty,
    const columnState& before,
    label& nTries
)
{
    const layerMoveControls& controls = editor.controls();
    const scalar least =
        controls.leanGain*penaltyAround(editor, c, penalty, 1, GREAT);

    if (least <= 0)
    {
        return false;
    }

    const List<vectorField> directions(trialDirections(editor, c));
    const label best = bestOf(editor, c, before, directions, penalty, least);
    ++nTries;

    if (best < 0)
    {
        editor.restore(c, before);

        return false;
    }

    editor.setDirections(c, before, directions[best]);

    return true;
}


labelList leanColumns
(
    layerEditor& editor,
    const labelUList& columns,
    const stackPenalty& penalty,
    const label maxTries,
    labelList& nTries
)
{
    const auto mayTry = [&](const label c) { return nTries[c] < maxTries; };

    return editor.inColours
    (
        subsetList(columns, mayTry),
        []() {},
        [&](const label c, const columnState& before)
        {
            return lean(editor, c, penalty, before, nTries[c]);
        }
    );
}

} // End namespace Foam

// ************************************************************************* //
