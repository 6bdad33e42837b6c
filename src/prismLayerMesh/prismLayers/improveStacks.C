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
#include "Map.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Share of the best scaled Jacobian that is good enough
static const scalar goodShare = 0.3;

//- Passes over the stacks
static const label nPasses = 2;

//- Fault of a stack that must not be
static const scalar forbidden = 1e3;

typedef Map<movingColumns::posture> postures;


//- Columns that leaned, as they were before
static postures leanWorst
(
    movingColumns& columns,
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
        const scalar best = bestJacobians[facei];
        const scalar own =
            poorness(layers, facei, goodShare*best, enough, lowest);

        return lowest == 1 && own <= enough && isPoor(layers, facei, best)
          ? forbidden : own;
    };

    postures before;
    columns.allowLeans(1);

    forAll(layers.faces, facei)
    {
        const scalar good = goodShare*bestJacobians[facei];

        for (const label c : layers.faces[facei])
        {
            if (worstJacobian(layers, facei, good) >= good)
            {
                break;
            }

            const movingColumns::posture own(columns.postureOf(c));

            if (columns.lean(c, fault))
            {
                before.insert(c, own);
            }
        }
    }

    return before;
}


//- Front faces that cannot be certified, of those moved since the last look
static labelList findFaults
(
    movingColumns& columns,
    const scalarField& bestJacobians
)
{
    const prismLayers& layers = columns.layers();
    const labelList moved(columns.takeCandidates());

    labelList faults(findPoorStacks(layers, bestJacobians, moved));
    faults.append(findWarpedStacks(layers, moved));

    for
    (
        const labelPair& pair
      : findIntersections(layers, columns.takeMoved())
    )
    {
        for (const label f : pair)
        {
            if (f >= layers.faces.size())
            {
                faults.append(f - layers.faces.size());
            }
        }
    }

    return faults;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::improveStacks
(
    movingColumns& columns,
    const scalarField& bestJacobians
)
{
    const faceList& faces = columns.layers().faces;

    for (label pass = 0; pass < nPasses; ++pass)
    {
        postures before(leanWorst(columns, bestJacobians));

        // What is taken back may be in the way of what is not
        for
        (
            labelList faults(findFaults(columns, bestJacobians));
            faults.size();
            faults = findFaults(columns, bestJacobians)
        )
        {
            for (const label facei : faults)
            {
                for (const label c : faces[facei])
                {
                    if (before.found(c))
                    {
                        columns.restore(c, before[c]);
                        before.erase(c);
                    }
                }
            }
        }
    }
}


// ************************************************************************* //
