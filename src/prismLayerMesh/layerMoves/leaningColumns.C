/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movingColumns.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- As how often a try counts that was in vain
static const label vainLean = 2;

//- What is left of the faults of the cells at most, for a column to lean
static const scalar leanGain = 0.98;

//- How far it may lean at a time, over the height, and to how many sides
static const scalar leanSizes[] = {0.1, 0.4};
static const label nLeans = 8;

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vectorField Foam::movingColumns::standing(const label c) const
{
    const label n = spacing_.nLayers;
    const scalar s = straightened_[c];

    vectorField offsets(n);
    for (label i = 0; i < n; ++i)
    {
        offsets[i] = (1 - s)*columns_.offsets[c*n + i]
          + s*columns_.axisOffset
            (
                front_.visibility, c, columns_.heights[c*n + i]
            );
    }

    return offsets;
}


Foam::List<Foam::vectorField> Foam::movingColumns::leaning
(
    const label c
) const
{
    const label n = spacing_.nLayers;
    const vector& axis = front_.visibility.cones[c].axis;
    const vectorField offsets(standing(c));
    DynamicList<vectorField> all;

    all.append(vectorField(n, axis));

    vectorField means(n);
    for (label i = 0; i < n; ++i)
    {
        means[i] = graph_.mean(columns_.offsets, c, n, i);
    }
    all.append(means);

    const vector across
    (
        mag(axis.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0)
    );
    const vector u(normalised(axis ^ across));
    const vector v(axis ^ u);

    for (const scalar size : leanSizes)
    {
        for (label k = 0; k < nLeans; ++k)
        {
            const scalar angle = constant::mathematical::twoPi*k/nLeans;
            const vector side(size*(::cos(angle)*u + ::sin(angle)*v));

            vectorField directions(offsets);
            for (label i = 0; i < n; ++i)
            {
                // Less so near to the wall, where columns stand upright
                directions[i] += ::sqrt
                (
                    columns_.heights[c*n + i]/columns_.heights[c*n + n - 1]
                )*side;
            }
            all.append(directions);
        }
    }

    return List<vectorField>(std::move(all));
}


void Foam::movingColumns::stand
(
    const label c,
    const vectorField& directions,
    const label lowest
)
{
    const label n = spacing_.nLayers;
    straightened_[c] = 0;

    // Offsets are for the heights asked for
    const label above = columns_.layerAt(c, heightsOf(c)[lowest - 1]);

    for (label i = max(above - 1, 0); i < n; ++i)
    {
        columns_.offsets[c*n + i] = columnOffset
        (
            front_.visibility, c, directions[i],
            columns_.stretch(c, columns_.heights[c*n + i])
        );
    }

    build(c, lowest - 1);
}


void Foam::movingColumns::resume(const label c, const posture& before)
{
    const label n = spacing_.nLayers;

    SubList<vector>(columns_.offsets, n, c*n) = before.offsets;
    straightened_[c] = before.straightened;
    columns_.room[c] = before.room;
    columns_.causes[c] = before.cause;
    SubList<point>(layers_.points, n, layers_.index(c, 1)) = before.points;
}


bool Foam::movingColumns::lean(const label c, const faceFault& fault)
{
    if (leans_[c] >= maxLeans_)
    {
        return false;
    }

    const labelList& faces = front_.addressing.pointFaces[c];

    // Up to where they are enough
    const auto faults = [&](const scalar enough, const label lowest)
    {
        scalar sum = 0;
        for (label i = 0; i < faces.size() && sum < enough; ++i)
        {
            sum += fault(faces[i], lowest, enough - sum);
        }

        return sum;
    };

    scalar least = leanGain*faults(GREAT, 1);

    if (least <= 0)
    {
        return false;
    }

    const posture before(postureOf(c));
    const label n = spacing_.nLayers;

    // No column has less fault than its outermost cells
    const List<vectorField> tries(leaning(c));
    scalarField outermost(tries.size());
    forAll(tries, k)
    {
        stand(c, tries[k], n);
        outermost[k] = faults(least, n);
    }

    label best = -1;
    for (const label k : sortedOrder(outermost))
    {
        if (outermost[k] >= least)
        {
            break;
        }

        stand(c, tries[k]);
        const scalar sum = faults(least, 1);

        if (sum < least)
        {
            least = sum;
            best = k;
        }
    }

    leans_[c] += best < 0 ? vainLean : 1;

    if (best < 0)
    {
        resume(c, before);

        return false;
    }

    stand(c, tries[best]);
    touch(c);

    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::movingColumns::posture Foam::movingColumns::postureOf
(
    const label c
) const
{
    const label n = spacing_.nLayers;

    return posture
    {
        vectorField(SubList<vector>(columns_.offsets, n, c*n)),
        pointField(SubList<point>(layers_.points, n, layers_.index(c, 1))),
        straightened_[c],
        columns_.room[c],
        columns_.causes[c]
    };
}


void Foam::movingColumns::restore(const label c, const posture& before)
{
    resume(c, before);
    touch(c);
}


void Foam::movingColumns::allowLeans(const label n)
{
    leans_ = 0;
    maxLeans_ = n;
}


Foam::labelList Foam::movingColumns::lean
(
    const labelUList& columns,
    const faceFault& fault
)
{
    boolList leaned(colours_.size(), false);
    List<DynamicList<label>> groups(max(colours_) + 1);

    for (const label c : columns)
    {
        groups[colours_[c]].append(c);
    }

    for (const labelUList& group : groups)
    {
        #pragma omp parallel for schedule(dynamic, 4) if (group.size() > 8)
        forAll(group, i)
        {
            leaned[group[i]] = lean(group[i], fault);
        }
    }

    return findIndices(leaned, true);
}


// ************************************************************************* //
