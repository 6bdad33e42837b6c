/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "certifyLayers.H"
#include "leanColumns.H"
#include "retreatColumns.H"
#include "scaledJacobian.H"
#include "stageProgress.H"

namespace Foam
{

//- The column by whose retreat the worst cell of a stack gains most, -1 if no
//  column's retreat helps; columns that are too short are not in the way
static label columnInTheWay(layerEditor& editor, const label facei)
{
    const face& f = editor.layers().faces[facei];
    const scalarField thickness(editor.thickness(), f);
    const scalar least = editor.controls().shortShare*max(thickness);
    scalar largest = worstJacobian(editor.layers(), facei);
    label column = -1;

    forAll(f, k)
    {
        if (thickness[k] > least && !editor.isFixed(f[k]))
        {
            const scalar after = jacobianOfRetreat(editor, facei, f[k]);

            if (after > largest)
            {
                largest = after;
                column = f[k];
            }
        }
    }

    return column;
}


//- Returns the own columns, ascending, of overlapping stacks that have at least
//  tallShare of the thickness of the tallest column of both stacks. Collective:
//  the stacks of all shares count.
static labelList tallColumns
(
    const layerEditor& editor,
    const UList<overlappingStack>& stacks
)
{
    boolList tall(editor.thickness().size(), false);
    for (const overlappingStack& stack : stacks)
    {
        const scalar least = editor.controls().tallShare*stack.tallest;
        for (const label c : editor.layers().faces[stack.facei])
        {
            tall[c] = tall[c] || editor.thickness()[c] >= least;
        }
    }
    editor.team().columns.unite(tall);

    return editor.team().ownOf(findIndices(tall, true));
}


//- Returns the own columns, ascending, that are in the way of stacks with
//  faulty cells: for each stack the column by whose retreat the worst cell
//  gains most, or the tallColumns of the stack if no retreat helps. Collective.
//  The layers change while retreats are tried, and are restored.
static labelList columnsInTheWay(layerEditor& editor, const labelUList& stacks)
{
    labelHashSet columns;
    DynamicList<overlappingStack> others;
    for (const label facei : stacks)
    {
        const label inTheWay = columnInTheWay(editor, facei);
        const label c =
            inTheWay < 0 ? inTheWay : editor.team().stateOwner(inTheWay);

        if (c < 0)
        {
            others.append
            ({
                facei, tallestOf(editor.layers(), facei, editor.thickness())
            });
        }
        else if (editor.team().isOwn(c))
        {
            columns.insert(c);
        }
    }

    columns.insert(tallColumns(editor, others));

    return columns.sortedToc();
}


// * * * * * * * * * * * * * *  Certify Layers * * * * * * * * * * * * * * * //

namespace
{

class layerCertifier
{
    layerEditor& editor_;
    const layerJudge& judge_;

    //- How often each column has turned, and tried to lean
    labelList nTurns_;
    labelList nLeans_;

    //- How often columns moved because a centre was outside
    Map<label> nCentreTries_;

    certification made_;

    //- Stacks below what is attainable, and those that were not judged further
    bitSet below_;
    bitSet unjudged_;

    //- Times of the journal up to which cells and overlaps were judged
    label cellsJudged_ = 0;
    label overlapsJudged_ = 0;

    //- Lean columns to where the penalties around them are less. False if all
    //  stay.
    bool lean(const labelUList& columns)
    {
        const auto penalty = [&]
        (
            const label facei,
            const label lowest,
            const scalar enough
        )
        {
            return judge_.penalty(facei, lowest, enough);
        };

        const labelList leaning
        (
            leanColumns
            (
                editor_, columns, penalty, editor_.controls().maxLeans, nLeans_
            )
        );

        return editor_.team().any(leaning.size());
    }

    //- Lower columns. False if some have no height left; then all stay.
    bool retreat(const labelUList& columns, const squeezeCause cause)
    {
        const columnTeam& team = editor_.team();
        DynamicList<labelPair> hopeless;
        for (const label c : columns)
        {
            const scalar least =
                editor_.controls().hopelessShare*editor_.spacing().thickness[c];

            if (editor_.isFixed(c) || editor_.thickness()[c] < least)
            {
                hopeless.append
                (
                    labelPair
                    (
                        team.wholeColumn(c),
                        team.wholeColumn(editor_.front().wallPoints[c])
                    )
                );
            }
        }

        if (team.any(hopeless.size()))
        {
            List<labelPair> all(team.gather(hopeless));
            sort(all);
            for (const labelPair& columnAndPoint : all)
            {
                made_.pointsWithoutHeight.append(columnAndPoint.second());
            }
            made_.cause = cause;

            return false;
        }

        made_.nRetreats += columns.size();
        retreatColumns(editor_, columns, cause);

        return true;
    }

    //- Whether columns of a stack, whose centres are outside, may move again
    //  because of it. Each question is a try.
    bool mayTry(const label facei)
    {
        if (made_.tolerated.test(facei))
        {
            return false;
        }
        made_.tolerated.set
        (
            facei,
            ++nCentreTries_(facei, 0) == editor_.controls().maxCentreTries
        );

        return true;
    }

    //- Stacks that have a fault now. Those below what is attainable come first;
    //  the rest is judged once there are none.
    labelList faultyStacks()
    {
        const labelList moved(editor_.touchedSince(cellsJudged_));
        cellsJudged_ = editor_.now();
        unjudged_.set(moved);
        below_.unset(moved);

        for
        (
            const faultyStack& stack
          : judge_.findFaults
            (
                moved, stackFault::belowAttainable, stackFault::belowAttainable
            )
        )
        {
            below_.set(stack.facei);
        }

        if (editor_.team().any(below_.any()))
        {
            return below_.toc();
        }

        const List<faultyStack> faults
        (
            judge_.findFaults
            (
                unjudged_.toc(),
                stackFault::notPositive, stackFault::centreOutside
            )
        );

        DynamicList<label> faulty(faults.size());
        for (const faultyStack& stack : faults)
        {
            if (stack.fault == stackFault::notPositive || mayTry(stack.facei))
            {
                faulty.append(stack.facei);
            }
        }
        unjudged_.reset();
        unjudged_.set(faulty);

        return labelList(std::move(faulty));
    }

    //- Until all cells are positive and good enough. False if columns have no
    //  height left.
    bool makePositive()
    {
        for
        (
            labelList faulty(faultyStacks());
            editor_.team().any(faulty.size());
            faulty = faultyStacks()
        )
        {
            const labelList moving(editor_.layers().columnsOf(faulty));
            tellProgress("moving columns with faulty cells", moving.size());

            if (turnColumns(editor_, moving, nTurns_) || lean(moving))
            {
                continue;
            }
            const labelList inTheWay(columnsInTheWay(editor_, faulty));
            if (!retreat(inTheWay, squeezeCause::validity))
            {
                return false;
            }
        }

        return true;
    }

    //- Columns of stacks that overlap, of those moved since the last look
    labelList overlappingColumns()
    {
        tellProgress("looking for intersections");
        const labelList moved(editor_.touchedSince(overlapsJudged_));
        overlapsJudged_ = editor_.now();

        return tallColumns
        (
            editor_,
            judge_.findOverlapping
            (
                moved, editor_.stackGroups(), editor_.thickness()
            )
        );
    }

public:

    layerCertifier(layerEditor& editor, const layerJudge& judge)
    :
        editor_(editor),
        judge_(judge),
        nTurns_(editor.thickness().size(), 0),
        nLeans_(editor.thickness().size(), 0)
    {}

    certification run()
    {
        bool goesOn = makePositive();

        while (goesOn)
        {
            const labelList columns(overlappingColumns());

            goesOn = editor_.team().any(columns.size())
             && retreat(columns, squeezeCause::intersection)
             && makePositive();
        }

        made_.nRetreats = editor_.team().sum(made_.nRetreats);

        return std::move(made_);
    }
};

} // End anonymous namespace


certification certifyLayers(layerEditor& editor, const layerJudge& judge)
{
    return layerCertifier(editor, judge).run();
}

} // End namespace Foam

// ************************************************************************* //
