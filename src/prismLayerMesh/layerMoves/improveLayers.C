/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "improveLayers.H"
#include "bendColumns.H"
#include "fitHeights.H"
#include "leanColumns.H"
#include "limitHeightJumps.H"
#include "retreatColumns.H"
#include "stageProgress.H"
#include "unitConversion.H"

namespace Foam
{

namespace
{

//- Rolls back the moves after which layers cannot be certified.
class faultRollBack
{
    layerEditor& editor_;
    const layerJudge& judge_;

    //- Front faces with cells whose centres may be outside
    const bitSet& tolerated_;

    //- Time of the journal up to which all is judged
    label judged_;

    //- Front faces that cannot be certified, of those moved since the last look
    //  first: earlier faults are not looked for
    labelList faultyFaces(const stackFault first)
    {
        const labelList moved(editor_.touchedSince(judged_));
        judged_ = editor_.now();
        DynamicList<label> faulty;
        for (const faultyStack& stack : judge_.findFaults(moved, first))
        {
            const bool isOutside = stack.fault == stackFault::centreOutside;
            if (!isOutside || !tolerated_.test(stack.facei))
            {
                faulty.append(stack.facei);
            }
        }
        for
        (
            const overlappingStack& stack
          : judge_.findOverlapping
            (
                moved, editor_.stackGroups(), editor_.thickness()
            )
        )
        {
            faulty.append(stack.facei);
        }

        return labelList(std::move(faulty));
    }

    //- The own columns of stacks that are faulty on any share
    labelList columnsAtFault(const labelUList& faulty) const
    {
        const columnTeam& team = editor_.team();
        boolList atFault(barred.size(), false);
        UIndirectList<bool>(atFault, editor_.layers().columnsOf(faulty)) = true;
        team.columns.unite(atFault);

        return team.ownOf(findIndices(atFault, true));
    }

    //- Roll back a column, and those on its point
    void rollBack(const label c, DynamicList<label>& rolledBack)
    {
        for (const label q : editor_.columnsBeside(c))
        {
            if (editor_.isChanged(q))
            {
                editor_.rollBack(q);
                barred[q] = true;
                rolledBack.append(q);
            }
        }
    }

public:

    //- Columns that had to be rolled back, since this list was set last
    boolList barred;


    //- Layers of the editor, which records, that can be certified. References
    //  must outlive the object.
    faultRollBack
    (
        layerEditor& editor,
        const layerJudge& judge,
        const bitSet& tolerated
    )
    :
        editor_(editor),
        judge_(judge),
        tolerated_(tolerated),
        judged_(editor.now()),
        barred(editor.thickness().size(), false)
    {}

    //- Whether a stack has a fault that its own cells show
    bool isAtFault(const label facei) const
    {
        return judge_.faultOf
        (
            facei, stackFault::belowAttainable, stackFault::notPositive
        ) != stackFault::none;
    }

    //- The own columns of stacks, but for barred ones
    labelList notBarredOf(const labelUList& stacks) const
    {
        return subsetList
        (
            editor_.team().ownOf(editor_.layers().columnsOf(stacks)),
            [&](const label c) { return !barred[c]; }
        );
    }

    //- Roll back columns until all can be certified, and keep what is left. The
    //  first look is for faults from 'first' on. Collective
    void settle(const stackFault first = stackFault::belowAttainable)
    {
        // What is rolled back may be in the way of what is not
        for
        (
            labelList faulty(faultyFaces(first));
            editor_.team().any(faulty.size());
            faulty = faultyFaces(stackFault::belowAttainable)
        )
        {
            DynamicList<label> rolledBack;
            for (const label c : columnsAtFault(faulty))
            {
                if (editor_.isChanged(c))
                {
                    rollBack(c, rolledBack);
                }
            }
            editor_.publish(rolledBack);
        }

        editor_.keep();
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * *  Improve Layers * * * * * * * * * * * * * * * //

//- Penalty of a stack that must not be
static const scalar forbidden = 1e3;

//- The first fault that a move does not look for that stays only where no stack
//  isAtFault: each stack was judged when the last of its columns moved
static const stackFault notAtFault = stackFault::centreOutside;

namespace
{

struct improvement
{
    layerEditor& editor;
    const layerJudge& judge;
    faultRollBack& moves;

    //- Columns that were bent with heights that give way
    labelHashSet gaveWay{};

    //- Time of the journal when the last round began
    label roundBegan = 0;


    //- Whether a stack has a fault that its own cells show
    bool isAtFault(const label facei) const
    {
        return moves.isAtFault(facei);
    }

    //- Front faces moved in the last round; now another one begins
    labelList beginRound()
    {
        const labelList moved(editor.touchedSince(roundBegan));
        roundBegan = editor.now();

        return moved;
    }

    //- Lean columns of stacks that are below their target
    void lean(const labelUList& faces)
    {
        const auto penalty = [&]
        (
            const label facei,
            const label lowest,
            const scalar enough
        )
        {
            const scalar own = judge.penalty(facei, lowest, enough);

            return lowest == 1 && own <= enough && isAtFault(facei)
              ? forbidden : own;
        };

        const labelList leaning
        (
            moves.notBarredOf
            (
                judge.findBelowAttainable(faces, editor.controls().goodJacobian)
            )
        );
        labelList nTries(moves.barred.size(), 0);
        leanColumns(editor, leaning, penalty, 1, nTries);
    }

    //- Give height back to columns of faces that retreated
    void grow(const labelUList& faces)
    {
        growColumns
        (
            editor,
            subsetList
            (
                moves.notBarredOf(faces),
                [&](const label c) { return isLowered(editor, c); }
            ),
            [&](const label facei) { return isAtFault(facei); }
        );
    }

    //- Keep the targets around columns, which are about to bend, on all shares
    void keepTargets(const labelUList& columns, bendTargets& targets) const
    {
        boolList kept(moves.barred.size(), false);
        UIndirectList<bool>(kept, columns) = true;
        editor.team().columns.update(kept);
        targets.keep(editor, findIndices(kept, true));
    }

    //- Bend columns of faces and cells beyond bounds, of stacks that are looked
    //  at, and of stacks around columns that bend. Returns the columns that
    //  bent and stay so.
    labelHashSet bendTo
    (
        const bendTargets& bounds,
        bendTargets& targets,
        editedGeometry& geometry,
        labelList looked
    )
    {
        const columnTeam& team = editor.team();
        const auto atFault = [&](const label facei)
        {
            return isAtFault(facei);
        };
        labelHashSet bent;
        moves.barred = false;

        const auto bendOnce = [&]()
        {
            const labelList columns
            (
                moves.notBarredOf
                (
                    stacksMissingTargets
                    (
                        editor.layers(), geometry.now(), looked, bounds
                    )
                )
            );
            keepTargets(columns, targets);
            tellProgress("bending columns", columns.size());

            const label then = editor.now();
            const labelList tried
            (
                bendColumns(editor, geometry, targets, columns, atFault)
            );
            moves.settle(notAtFault);

            for (const label c : tried)
            {
                if (!moves.barred[c])
                {
                    bent.insert(c);
                }
            }
            looked = editor.touchedSince(then);

            return team.any(looked.size());
        };
        if (team.any(looked.size()))
        {
            repeatUntilStable
            (
                "bending columns", editor.controls().maxBends, bendOnce
            );
        }

        return bent;
    }

    void leanAndGrow()
    {
        for (label round = 0; round < editor.controls().maxRounds; ++round)
        {
            tellProgress
            (
                "leaning and growing columns, round",
                round + 1, editor.controls().maxRounds
            );
            const labelList faces(beginRound());
            lean(faces);
            grow(faces);
            moves.settle(notAtFault);
        }
        lean(beginRound());
        moves.settle(notAtFault);
    }

    //- Fit columns to the first heights that are asked for, those that have to
    //  be rolled back again nearer to the wall
    void fitFirst()
    {
        boolList wanted(moves.barred.size(), true);

        for (const scalar reach : editor.controls().reaches)
        {
            tellProgress("fitting first heights");
            moves.barred = false;
            fitFirstHeights(editor, wanted, reach);
            moves.settle();
            editor.team().columns.update(moves.barred);
            wanted = moves.barred;
        }
    }

    void limitJumps()
    {
        const List<labelPair> neighbours(neighboursOnWall(editor.front()));

        const auto limit = [&]()
        {
            const bool anyLimited = limitHeightJumps(editor, neighbours);
            if (anyLimited)
            {
                moves.settle();
            }

            return anyLimited;
        };
        repeatUntilStable("limiting jumps", editor.controls().maxLimits, limit);
    }

    void fitAll()
    {
        tellProgress("fitting thicknesses");
        fitThickness(editor);
        moves.settle();
    }

    //- Bend columns to where faces are better: with heights as they are, then
    //  as the user's priority is with heights that give way
    void bend()
    {
        const layerMoveControls& controls = editor.controls();
        const qualityControls& quality = controls.quality;

        bendTargets targets
        (
            bendTargets::withMargins(controls, judge.attainable())
        );
        editedGeometry geometry(editor);
        const label then = editor.now();
        const faceList& faces = editor.layers().faces;
        const labelList all
        (
            editor.team().withOwn(identity(faces.size()), faces)
        );
        bendTargets bounds(targets);
        bounds.gain = GREAT;
        labelList stacks
        (
            stacksMissingTargets(editor.layers(), geometry.now(), all, bounds)
        );
        bendTo(bounds, targets, geometry, stacks);

        // Large gains count more than faces, but few columns bend for them
        bounds = bendTargets();
        bounds.gain = controls.maxGain;
        targets.gainWeight = controls.largeGainWeight;
        bendTo(bounds, targets, geometry, all);
        targets.gainWeight = controls.gainWeight;

        if (quality.priority == qualityControls::priorities::quality)
        {
            bounds.gain = GREAT;
            bounds.faces = faceTargets
            {
                Foam::cos(degToRad(quality.maxNonOrtho)),
                quality.maxInternalSkewness, SMALL
            };

            const auto giveWay = [&]()
            {
                const labelList moved(editor.allTouchedSince(then));
                stacks.append
                (
                    editor.team().withOwn
                    (
                        geometry.now().withNeighbours(moved), faces
                    )
                );
                inplaceUniqueSort(stacks);
                gaveWay |= bendTo(bounds, targets, geometry, stacks);
            };
            targets.thicknessWeight = controls.lowThicknessWeight;
            giveWay();
            targets.firstHeightWeight = controls.lowFirstHeightWeight;
            giveWay();
        }
    }
};

} // End anonymous namespace


labelList improveLayers
(
    layerEditor& editor,
    const layerJudge& judge,
    const bitSet& tolerated
)
{
    editor.record();
    faultRollBack moves(editor, judge, tolerated);
    improvement better{editor, judge, moves};
    better.leanAndGrow();

    if (!editor.proposed().onLevelSets)
    {
        better.fitFirst();
        better.limitJumps();
        better.fitAll();
        better.bend();
    }

    return better.gaveWay.sortedToc();
}

} // End namespace Foam

// ************************************************************************* //
