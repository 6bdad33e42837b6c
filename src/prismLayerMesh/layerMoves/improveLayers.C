/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "improveLayers.H"
#include "bendColumns.H"
#include "fitHeights.H"
#include "growColumns.H"
#include "leanColumns.H"
#include "limitHeightJumps.H"
#include "stageProgress.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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

    //- Front faces with cells whose centres may be outside
    const bitSet& tolerated;

    //- Columns that had to be rolled back, and stay
    boolList barred = boolList(editor.thickness().size(), false);

    //- Columns that were bent with heights that give way
    labelHashSet gaveWay{};

    //- Times of the journal: when the last round began, and up to which all is
    //  judged
    label roundBegan = 0;
    label judged = editor.now();


    //- Whether a stack has a fault that its own cells show
    bool isAtFault(const label facei) const
    {
        return judge.faultOf
        (
            facei, stackFault::belowAttainable, stackFault::notPositive
        ) != stackFault::none;
    }

    //- Front faces moved in the last round; now another one begins
    labelList beginRound()
    {
        const labelList moved(editor.touchedSince(roundBegan));
        roundBegan = editor.now();

        return moved;
    }

    //- The columns of stacks that had not to be rolled back
    labelList notBarredOf(const labelUList& stacks) const
    {
        return subsetList
        (
            editor.layers().columnsOf(stacks),
            [&](const label c) { return !barred[c]; }
        );
    }

    //- Lean columns of stacks that are below their target
    void lean(const labelUList& faces);

    //- Give height back to columns of faces that retreated
    void grow(const labelUList& faces);

    //- Front faces that cannot be certified, of those moved since the last look
    //  first: earlier faults are not looked for
    labelList faultyFaces(stackFault first);

    //- Roll back a column, and those on its point
    void rollBack(const label c)
    {
        for (const label q : editor.columnsBeside(c))
        {
            if (editor.isChanged(q))
            {
                editor.rollBack(q);
                barred[q] = true;
            }
        }
    }

    //- Roll back columns until all can be certified. The first look is for
    //  faults from 'first' on.
    void settle(stackFault first = stackFault::belowAttainable);

    //- Bend columns of faces that are beyond bounds, of stacks that are looked
    //  at, and of stacks around columns that bend. Returns the columns that
    //  bent and stay so.
    labelHashSet bendTo
    (
        const faceTargets& bounds,
        bendTargets& targets,
        editedGeometry& geometry,
        labelList looked
    );

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
            settle(notAtFault);
        }
        lean(beginRound());
        settle(notAtFault);
    }

    //- Fit columns to the first heights that are asked for, those that have to
    //  be rolled back again nearer to the wall
    void fitFirst();

    void limitJumps();

    void fitAll()
    {
        tellProgress("fitting thicknesses");
        fitThickness(editor);
        settle();
    }

    //- Bend columns to where faces are better: with heights as they are, then
    //  as the user's priority is with heights that give way
    void bend();
};


void improvement::lean(const labelUList& faces)
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
        notBarredOf
        (
            judge.findBelowAttainable
            (
                faces, editor.controls().goodJacobian
            )
        )
    );
    labelList nTries(barred.size(), 0);
    leanColumns(editor, leaning, penalty, 1, nTries);
}


void improvement::grow(const labelUList& faces)
{
    growColumns
    (
        editor,
        subsetList
        (
            notBarredOf(faces),
            [&](const label c) { return isLowered(editor, c); }
        ),
        [&](const label facei) { return isAtFault(facei); }
    );
}


labelList improvement::faultyFaces(const stackFault first)
{
    const labelList moved(editor.touchedSince(judged));
    judged = editor.now();
    DynamicList<label> faulty;

    for (const faultyStack& stack : judge.findFaults(moved, first))
    {
        const bool isOutside = stack.fault == stackFault::centreOutside;
        if (!isOutside || !tolerated.test(stack.facei))
        {
            faulty.append(stack.facei);
        }
    }
    for (const labelPair& pair : judge.findOverlapping(moved))
    {
        faulty.append(pair.first());
        faulty.append(pair.second());
    }

    return labelList(std::move(faulty));
}


void improvement::settle(const stackFault first)
{
    // What is rolled back may be in the way of what is not
    for
    (
        labelList faulty(faultyFaces(first));
        faulty.size();
        faulty = faultyFaces(stackFault::belowAttainable)
    )
    {
        for (const label facei : faulty)
        {
            for (const label c : editor.layers().faces[facei])
            {
                if (editor.isChanged(c))
                {
                    rollBack(c);
                }
            }
        }
    }

    editor.keep();
}


void improvement::fitFirst()
{
    boolList wanted(barred.size(), true);

    for (const scalar reach : editor.controls().reaches)
    {
        tellProgress("fitting first heights");
        barred = false;
        fitFirstHeights(editor, wanted, reach);
        settle();
        wanted = barred;
    }
}


void improvement::limitJumps()
{
    const List<labelPair> neighbours(neighboursOnWall(editor.front()));

    for
    (
        label i = 0;
        i < editor.controls().maxLimits
     && limitHeightJumps(editor, neighbours);
        ++i
    )
    {
        settle();
    }
}


labelHashSet improvement::bendTo
(
    const faceTargets& bounds,
    bendTargets& targets,
    editedGeometry& geometry,
    labelList looked
)
{
    const layerMoveControls& controls = editor.controls();
    const auto atFault = [&](const label facei) { return isAtFault(facei); };
    labelHashSet bent;
    barred = false;

    for (label round = 0; round < controls.maxBends && looked.size(); ++round)
    {
        const labelList columns
        (
            notBarredOf(stacksMissingTargets(geometry.now(), looked, bounds))
        );
        targets.keep(editor, columns);
        tellProgress("bending columns", columns.size());

        const label then = editor.now();
        const labelList tried
        (
            bendColumns(editor, geometry, targets, columns, atFault)
        );
        settle(notAtFault);

        for (const label c : tried)
        {
            if (!barred[c])
            {
                bent.insert(c);
            }
        }
        looked = editor.touchedSince(then);
    }

    return bent;
}


void improvement::bend()
{
    const layerMoveControls& controls = editor.controls();
    const qualityControls& quality = controls.quality;

    bendTargets targets(bendTargets::withMargins(controls));
    editedGeometry geometry(editor);
    const label then = editor.now();
    const labelList all(identity(editor.layers().faces.size()));
    labelList stacks(stacksMissingTargets(geometry.now(), all, targets.faces));
    bendTo(targets.faces, targets, geometry, stacks);

    if (quality.priority == qualityControls::priorities::quality)
    {
        const faceTargets bounds
        {
            Foam::cos(degToRad(quality.maxNonOrtho)),
            quality.maxInternalSkewness, SMALL
        };

        const auto giveWay = [&]()
        {
            stacks.append
            (
                geometry.now().withNeighbours(editor.touchedSince(then))
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

}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList improveLayers
(
    layerEditor& editor,
    const layerJudge& judge,
    const bitSet& tolerated
)
{
    improvement better{editor, judge, tolerated};
    editor.record();
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
