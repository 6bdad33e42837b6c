/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "improveStacks.H"
#include "poorStacks.H"
#include "prismQuality.H"
#include "boolList.H"
#include "Map.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Share of the best scaled Jacobian that is good enough
static const scalar goodShare = 0.3;

//- Rounds over the stacks at most. No more of them once half as many stacks
//  were found not to be good as there are: where many are squeezed, they take
//  long.
static const label maxRounds = 4;

//- Heights up to which columns are fitted, over the length of their edges
static const scalarList reaches({1, 0.3, 0.1});

//- How often first heights are made even: what has to be taken back may leave
//  neighbours that are lower
static const label maxEvenings = 3;

//- Fault of a stack that must not be
static const scalar forbidden = 1e3;


class stackImprovement
{
    movingColumns& columns_;
    const prismLayers& layers_;
    const scalarField& bestJacobians_;

    //- As findOutlyingCentres wants it
    const labelUList& patience_;

    //- Faces to look at again, because something moved there
    boolList toLean_;
    boolList toGrow_;

    //- Columns that had to be taken back, and stay
    boolList barred_;

    //- How often a stack was found not to be good
    label nNotGood_ = 0;

    //- Columns that moved since all was certified, as they were then
    Map<movingColumns::posture> before_;


    bool isForbidden(const label facei) const
    {
        return isPoor(layers_, facei, bestJacobians_[facei])
            || !isPositiveStack(layers_, facei);
    }

    //- Front faces that cannot be certified, of those moved since the last look
    labelList findFaults();

    //- Keep what a column is before it moves
    void remember(const label c)
    {
        before_.insert(c, columns_.postureOf(c));
    }

    //- Take back a column and those beside it
    void takeBack(label c);

public:

    stackImprovement
    (
        movingColumns& columns,
        const scalarField& bestJacobians,
        const labelUList& patience
    )
    :
        columns_(columns),
        layers_(columns.layers()),
        bestJacobians_(bestJacobians),
        patience_(patience),
        toLean_(layers_.faces.size(), true),
        toGrow_(layers_.faces.size(), true),
        barred_(columns.room().size(), false)
    {}

    //- Whether many stacks are not good, and had their turn
    bool isEnough() const
    {
        return 2*nNotGood_ > layers_.faces.size();
    }

    //- Lean columns of stacks that are not good
    void lean();

    //- Give height back to columns that retreated
    void grow();

    //- Fit columns to the first heights that are asked for, those that have to
    //  be taken back again nearer to the wall
    void fit();

    //- No first heights that are too high, or change too much along the wall
    void even();

    //- No faces that are too thick, above their first layers
    void fitThickness();

    //- Take columns back until all can be certified
    void settle();
};


labelList stackImprovement::findFaults()
{
    const labelList moved(columns_.takeCandidates());

    UIndirectList<bool>(toLean_, moved) = true;
    UIndirectList<bool>(toGrow_, moved) = true;

    labelList faults(findPoorStacks(layers_, bestJacobians_, moved));
    faults.append(findUncertifiedStacks(layers_, moved));

    labelList patience(patience_);
    faults.append
    (
        findOutlyingCentres(layers_, bestJacobians_, moved, patience)
    );

    for
    (
        const labelPair& pair : findOverlaps(layers_, columns_.takeMoved())
    )
    {
        for (const label f : pair)
        {
            if (f >= layers_.faces.size())
            {
                faults.append(f - layers_.faces.size());
            }
        }
    }

    return faults;
}


void stackImprovement::takeBack(const label c)
{
    for (const label q : columns_.columnsBeside(c))
    {
        if (before_.found(q))
        {
            columns_.restore(q, before_[q]);
            before_.erase(q);
            barred_[q] = true;
        }
    }
}


void stackImprovement::settle()
{
    // What is taken back may be in the way of what is not
    for
    (
        labelList faults(findFaults());
        faults.size();
        faults = findFaults()
    )
    {
        for (const label facei : faults)
        {
            for (const label c : layers_.faces[facei])
            {
                if (before_.found(c))
                {
                    takeBack(c);
                }
            }
        }
    }

    before_.clear();
}


void stackImprovement::lean()
{
    const auto fault = [&]
    (
        const label facei,
        const label lowest,
        const scalar enough
    )
    {
        const scalar best = bestJacobians_[facei];
        const scalar own =
            poorness(layers_, facei, goodShare*best, enough, lowest);

        return lowest == 1 && own <= enough && isForbidden(facei)
          ? forbidden : own;
    };

    columns_.allowLeans(1);

    const labelList notGood
    (
        findPoorStacks
        (
            layers_, bestJacobians_, findIndices(toLean_, true), goodShare
        )
    );

    nNotGood_ += notGood.size();
    toLean_ = false;

    boolList leaning(barred_.size(), false);
    for (const label facei : notGood)
    {
        for (const label c : layers_.faces[facei])
        {
            if (!barred_[c] && !leaning[c])
            {
                leaning[c] = true;
                remember(c);
            }
        }
    }

    const labelList leaned(columns_.lean(findIndices(leaning, true), fault));
    before_.retain(labelHashSet(leaned));
}


void stackImprovement::grow()
{
    const auto atFault = [&](const label facei)
    {
        return isForbidden(facei);
    };
    boolList grown(barred_.size(), false);

    const labelList looking(findIndices(toGrow_, true));
    toGrow_ = false;

    for (const label facei : looking)
    {
        for (const label c : layers_.faces[facei])
        {
            if (columns_.lowered(c) && !barred_[c] && !grown[c])
            {
                const labelList all(columns_.columnsBeside(c));
                List<movingColumns::posture> own(all.size());
                forAll(all, i)
                {
                    own[i] = columns_.postureOf(all[i]);
                }

                if (columns_.grow(all, atFault))
                {
                    forAll(all, i)
                    {
                        grown[all[i]] = true;
                        before_.insert(all[i], own[i]);
                    }
                }
            }
        }
    }
}


void stackImprovement::fit()
{
    boolList wanted(barred_.size(), true);
    const auto moving = [&](const label c) { remember(c); };

    for (const scalar reach : reaches)
    {
        barred_ = false;
        columns_.fitFirst(wanted, reach, moving);
        settle();
        wanted = barred_;
    }
}


void stackImprovement::even()
{
    const auto moving = [&](const label c) { remember(c); };

    for (label i = 0; i < maxEvenings && columns_.even(moving); ++i)
    {
        settle();
    }
}


void stackImprovement::fitThickness()
{
    columns_.fitThickness([&](const label c) { remember(c); });
    settle();
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::improveStacks
(
    movingColumns& columns,
    const scalarField& bestJacobians,
    const labelUList& patience
)
{
    stackImprovement improvement(columns, bestJacobians, patience);

    for
    (
        label round = 0;
        round < maxRounds && !improvement.isEnough();
        ++round
    )
    {
        improvement.lean();
        improvement.grow();
        improvement.settle();
    }

    improvement.lean();
    improvement.settle();

    if (!columns.onLevelSets())
    {
        improvement.fit();
        improvement.even();
        improvement.fitThickness();
    }
}


// ************************************************************************* //
