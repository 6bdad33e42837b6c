/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "makePrismLayers.H"
#include "improveStacks.H"
#include "poorStacks.H"
#include "prismQuality.H"
#include "tallColumns.H"
#include "wallPointsError.H"
#include "HashSet.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Share of the tallest room beside which a column retreats too
static const scalar tallShare = 0.8;

//- Share of the largest gain of a cell by the retreat of one of its columns
//  with which a column retreats too
static const scalar gainShare = 0.5;

//- Share of the tallest room below which a column is not what is in the way
static const scalar shortShare = 0.05;


//- Share of the best scaled Jacobian that leaning columns aim at
static const scalar goodShare = 0.1;

//- How often columns move because the centre of a cell is not inside
static const label maxPatience = 12;


//- Each of the faces as both of a pair
static List<labelPair> selfPairs(const labelUList& faces)
{
    List<labelPair> pairs(faces.size());
    forAll(faces, i)
    {
        pairs[i] = labelPair(faces[i], faces[i]);
    }

    return pairs;
}


//- Those columns of the stacks by whose retreat their worst cells gain; the
//  tall ones where none does
static labelList culprits(movingColumns& columns, const labelUList& poor)
{
    const faceList& faces = columns.front().surface.faces;
    boolList retreating(columns.room().size(), false);
    DynamicList<label> others;

    for (const label facei : poor)
    {
        const face& f = faces[facei];
        const scalarField room(columns.room(), f);
        const scalar before = worstJacobian(columns.layers(), facei);
        scalarField gains(f.size(), 0);
        forAll(f, k)
        {
            if (room[k] > shortShare*max(room))
            {
                gains[k] = columns.jacobianOfRetreat(facei, f[k]) - before;
            }
        }

        const scalar largest = max(gains);
        if (largest <= 0)
        {
            others.append(facei);
        }

        forAll(f, k)
        {
            if (largest > 0 && gains[k] >= gainShare*largest)
            {
                retreating[f[k]] = true;
            }
        }
    }

    for
    (
        const label c
      : tallColumns(faces, selfPairs(others), columns.room(), tallShare)
    )
    {
        retreating[c] = true;
    }

    return findIndices(retreating, true);
}


//- wallPointsError where columns that retreat have no height left
static void giveUpHopeless
(
    const movingColumns& columns,
    const labelUList& retreating,
    const char* what
)
{
    const layerFront& front = columns.front();
    DynamicList<label> lost;

    for (const label c : retreating)
    {
        if (columns.hopeless(c))
        {
            lost.append(front.wallPoints[c]);
        }
    }

    if (lost.size())
    {
        throw wallPointsError(front.surface, lost, what);
    }
}


static labelList columnsOf
(
    const movingColumns& columns,
    const labelUList& faces
)
{
    return tallColumns
    (
        columns.front().surface.faces, selfPairs(faces), columns.room(), 0
    );
}


//- Lean columns to where their stacks are less poor. False where all stay.
static bool lean
(
    movingColumns& columns,
    const labelUList& leaning,
    const scalarField& bestJacobians
)
{
    const prismLayers& layers = columns.layers();
    const auto fault = [&]
    (
        const label facei,
        const label lowest,
        const scalar enough
    )
    {
        const scalar good = goodShare*bestJacobians[facei];

        return poorness(layers, facei, good, enough, lowest);
    };

    return columns.lean(leaning, fault).size();
}


//- Until all cells are positive and good enough
static void makePositive
(
    movingColumns& columns,
    const scalarField& bestJacobians,
    labelList& patience
)
{
    const prismLayers& layers = columns.layers();
    boolList unmeasured(layers.faces.size(), false);
    boolList isPoor(layers.faces.size(), false);

    while (true)
    {
        const labelList moved(columns.takeCandidates());
        UIndirectList<bool>(unmeasured, moved) = true;
        UIndirectList<bool>(isPoor, moved) = false;
        UIndirectList<bool>
        (
            isPoor, findPoorStacks(layers, bestJacobians, moved)
        ) = true;
        labelList poor(findIndices(isPoor, true));

        if (poor.empty())
        {
            const labelList candidates(findIndices(unmeasured, true));
            unmeasured = false;
            poor = findUncertifiedStacks(layers, candidates);
            poor.append
            (
                findOutlyingCentres
                (
                    layers, bestJacobians, candidates, patience
                )
            );
            UIndirectList<bool>(unmeasured, poor) = true;
        }

        if (poor.empty())
        {
            return;
        }

        const labelList moving(columnsOf(columns, poor));

        if
        (
            !columns.turn(moving)
         && !lean(columns, moving, bestJacobians)
        )
        {
            const labelList retreating(culprits(columns, poor));

            giveUpHopeless
            (
                columns,
                retreating,
                "have columns whose cells are not positive at any thickness"
            );
            columns.retreat(retreating, squeezeCause::validity);
        }
    }
}


//- Front faces whose outer sides intersect, one of each pair moved since the
//  last look
static List<labelPair> intersectingFaces(movingColumns& columns)
{
    const label nFaces = columns.layers().faces.size();
    List<labelPair> pairs
    (
        findOverlaps(columns.layers(), columns.takeMoved())
    );

    for (labelPair& pair : pairs)
    {
        // A face of the wall cannot move; the other one does
        const label outer = max(pair.first(), pair.second());

        for (label& f : pair)
        {
            f = (f < nFaces ? outer : f) - nFaces;
        }
    }

    return pairs;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::prismLayers Foam::makePrismLayers
(
    const layerFront& front,
    const layerSpacing& spacing,
    layerColumns& columns
)
{
    movingColumns moving(front, spacing, columns);
    const scalarField best(bestJacobians(front.surface, front.visibility));
    labelList patience(front.surface.faces.size(), maxPatience);

    while (true)
    {
        makePositive(moving, best, patience);

        const List<labelPair> pairs(intersectingFaces(moving));

        if (pairs.empty())
        {
            improveStacks(moving, best, patience);

            return moving.result();
        }

        const labelList retreating
        (
            tallColumns(front.surface.faces, pairs, moving.room(), tallShare)
        );

        giveUpHopeless
        (
            moving,
            retreating,
            "have columns whose outer faces intersect at any thickness"
        );
        moving.retreat(retreating, squeezeCause::intersection);
    }
}

// ************************************************************************* //
