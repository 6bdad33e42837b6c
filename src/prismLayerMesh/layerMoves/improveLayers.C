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
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Penalty of a stack that must not be
static const scalar forbidden = 1e3;

namespace
{

class improvement
{
    layerEditor& editor_;
    const layerJudge& judge_;

    //- Front faces with cells whose centres may be outside
    const bitSet& tolerated_;

    //- Columns that had to be rolled back, and stay
    boolList barred_;

    //- Columns that were bent with heights that give way
    labelHashSet gaveWay_;

    //- Times of the journal: when the last round began, and up to which all is
    //  judged
    label roundBegan_ = 0;
    label judged_;


    //- Whether a stack has a fault that its own cells show
    bool isAtFault(const label facei) const
    {
        return judge_.faultOf
        (
            facei, stackFault::belowAttainable, stackFault::notPositive
        ) != stackFault::none;
    }

    //- Front faces moved in the last round; now another one begins
    labelList beginRound()
    {
        const labelList moved(editor_.touchedSince(roundBegan_));
        roundBegan_ = editor_.now();

        return moved;
    }

    //- The columns of stacks that had not to be rolled back
    labelList notBarredOf(const labelUList& stacks) const
    {
        return subsetList
        (
            editor_.layers().columnsOf(stacks),
            [&](const label c) { return !barred_[c]; }
        );
    }

    //- Lean columns of stacks that are below their aim
    void lean(const labelUList& faces);

    //- Give height back to columns of faces that retreated
    void grow(const labelUList& faces);

    //- Front faces that cannot be certified, of those moved since the last look
    labelList faultyFaces();

    //- Roll back a column, and those on its point
    void rollBack(const label c)
    {
        for (const label q : editor_.columnsBeside(c))
        {
            if (editor_.isChanged(q))
            {
                editor_.rollBack(q);
                barred_[q] = true;
            }
        }
    }

    //- Roll back columns until all can be certified
    void settle();

    //- Bend columns of faces that are beyond bounds, of stacks that are looked
    //  at, and of stacks around columns that bend. Returns the columns that
    //  bent and stay so.
    labelHashSet bendTo
    (
        const faceAims& bounds,
        bendAims& aims,
        editedGeometry& geometry,
        labelList looked
    );

public:

    improvement
    (
        layerEditor& editor,
        const layerJudge& judge,
        const bitSet& tolerated
    )
    :
        editor_(editor),
        judge_(judge),
        tolerated_(tolerated),
        barred_(editor.thickness().size(), false),
        judged_(editor.now())
    {
        editor_.record();
    }

    void leanAndGrow()
    {
        for (label round = 0; round < editor_.controls().maxRounds; ++round)
        {
            const labelList faces(beginRound());
            lean(faces);
            grow(faces);
            settle();
        }
        lean(beginRound());
        settle();
    }

    //- Fit columns to the first heights that are asked for, those that have to
    //  be rolled back again nearer to the wall
    void fitFirst();

    void limitJumps();

    void fitAll()
    {
        fitThickness(editor_);
        settle();
    }

    //- Columns that bent with heights that give way, in ascending order
    labelList gaveWay() const { return gaveWay_.sortedToc(); }

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
        const scalar own = judge_.penalty(facei, lowest, enough);

        return lowest == 1 && own <= enough && isAtFault(facei)
          ? forbidden : own;
    };

    const labelList leaning
    (
        notBarredOf
        (
            judge_.findBelowAttainable
            (
                faces, editor_.controls().goodJacobian
            )
        )
    );
    labelList nTries(barred_.size(), 0);
    leanColumns(editor_, leaning, penalty, 1, nTries);
}


void improvement::grow(const labelUList& faces)
{
    const auto atFault = [&](const label facei) { return isAtFault(facei); };
    labelHashSet grown;

    for (const label facei : faces)
    {
        for (const label c : editor_.layers().faces[facei])
        {
            if (isLowered(editor_, c) && !barred_[c] && !grown.found(c))
            {
                const labelList all(editor_.columnsBeside(c));

                if (growColumns(editor_, all, atFault))
                {
                    grown.insert(all);
                }
            }
        }
    }
}


labelList improvement::faultyFaces()
{
    const labelList moved(editor_.touchedSince(judged_));
    judged_ = editor_.now();
    DynamicList<label> faulty;

    for (const faultyStack& stack : judge_.findFaults(moved))
    {
        const bool isOutside = stack.fault == stackFault::centreOutside;
        if (!isOutside || !tolerated_.test(stack.facei))
        {
            faulty.append(stack.facei);
        }
    }
    for (const labelPair& pair : judge_.findOverlapping(moved))
    {
        faulty.append(pair.first());
        faulty.append(pair.second());
    }

    return labelList(std::move(faulty));
}


void improvement::settle()
{
    // What is rolled back may be in the way of what is not
    for
    (
        labelList faulty(faultyFaces());
        faulty.size();
        faulty = faultyFaces()
    )
    {
        for (const label facei : faulty)
        {
            for (const label c : editor_.layers().faces[facei])
            {
                if (editor_.isChanged(c))
                {
                    rollBack(c);
                }
            }
        }
    }

    editor_.keep();
}


void improvement::fitFirst()
{
    boolList wanted(barred_.size(), true);

    for (const scalar reach : editor_.controls().reaches)
    {
        barred_ = false;
        fitFirstHeights(editor_, wanted, reach);
        settle();
        wanted = barred_;
    }
}


void improvement::limitJumps()
{
    const List<labelPair> neighbours(neighboursOnWall(editor_.front()));

    for
    (
        label i = 0;
        i < editor_.controls().maxLimits
     && limitHeightJumps(editor_, neighbours);
        ++i
    )
    {
        settle();
    }
}


labelHashSet improvement::bendTo
(
    const faceAims& bounds,
    bendAims& aims,
    editedGeometry& geometry,
    labelList looked
)
{
    const layerMoveControls& controls = editor_.controls();
    const auto atFault = [&](const label facei) { return isAtFault(facei); };
    labelHashSet bent;
    barred_ = false;

    for (label round = 0; round < controls.maxBends && looked.size(); ++round)
    {
        const labelList columns
        (
            notBarredOf(poorStacks(geometry.now(), looked, bounds))
        );
        aims.hold(editor_, columns);

        const label then = editor_.now();
        const labelList tried
        (
            bendColumns(editor_, geometry, aims, columns, atFault)
        );
        settle();

        for (const label c : tried)
        {
            if (!barred_[c])
            {
                bent.insert(c);
            }
        }
        looked = editor_.touchedSince(then);
    }

    return bent;
}


void improvement::bend()
{
    const layerMoveControls& controls = editor_.controls();
    const qualityControls& quality = controls.quality;

    bendAims aims(bendAims::withMargins(controls));
    editedGeometry geometry(editor_);
    const label then = editor_.now();
    const labelList all(identity(editor_.layers().faces.size()));
    labelList poor(poorStacks(geometry.now(), all, aims.faces));
    bendTo(aims.faces, aims, geometry, poor);

    if (quality.priority == qualityControls::priorities::quality)
    {
        const faceAims bounds
        {
            Foam::cos(degToRad(quality.maxNonOrtho)),
            quality.maxInternalSkewness, SMALL
        };

        const auto giveWay = [&]()
        {
            poor.append
            (
                geometry.now().withNeighbours(editor_.touchedSince(then))
            );
            inplaceUniqueSort(poor);
            gaveWay_ |= bendTo(bounds, aims, geometry, poor);
        };
        aims.thicknessWeight = controls.lowThicknessWeight;
        giveWay();
        aims.firstHeightWeight = controls.lowFirstHeightWeight;
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
    improvement better(editor, judge, tolerated);
    better.leanAndGrow();

    if (!editor.proposed().onLevelSets)
    {
        better.fitFirst();
        better.limitJumps();
        better.fitAll();
        better.bend();
    }

    return better.gaveWay();
}

} // End namespace Foam

// ************************************************************************* //
