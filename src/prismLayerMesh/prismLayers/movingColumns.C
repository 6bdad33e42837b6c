/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movingColumns.H"
#include "prismQuality.H"
#include "wallClearance.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- How often a column turns to its neighbours before it retreats
static const label maxTurns = 10;

//- How often it tries to lean to where its cells are better
static const label maxLeans = 4;

//- What is left of the faults of the cells at most, for a column to lean
static const scalar leanGain = 0.98;

//- How far it may lean at a time, over the height, and to how many sides
static const scalar leanSizes[] = {0.1, 0.4};
static const label nLeans = 8;

//- What a move leaves of the height of a column that retreats
static const scalar retreatFactor = 0.8;

//- What it takes of the way back to the axis of the visibility cone
static const scalar straightenShare = 0.25;

//- Bound on the gradient of the heights along the wall
static const scalar heightSlope = 1;

//- What is left of the height of a column when there is no hope for it
static const scalar hopelessShare = 1e-9;

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::movingColumns::build(const label c)
{
    const label n = spacing_.nLayers;
    const wallVisibility& visibility = front_.visibility;
    scalarList heights(n + 1);
    layerHeights
    (
        n,
        spacing_.firstThickness[c],
        spacing_.ratio[c],
        columns_.room[c],
        heights
    );

    const vector axis
    (
        columnOffset(visibility, c, visibility.cones[c].axis, maxStretch_)
    );
    const scalar s = straightened_[c];

    for (label i = 0; i <= n; ++i)
    {
        layers_.points[layers_.index(c, i)] = front_.surface.points[c]
          + heights[i]
           *((1 - s)*columns_.offset(c, heights[i]) + s*axis);
    }
}


void Foam::movingColumns::touch(const label c)
{
    for (const label facei : front_.addressing.pointFaces[c])
    {
        candidates_[facei] = true;
        moved_[facei] = true;
    }
}


void Foam::movingColumns::rebuild(const boolList& columns)
{
    forAll(columns, c)
    {
        if (columns[c])
        {
            build(c);
            touch(c);
        }
    }
}


void Foam::movingColumns::takeBack(const label c)
{
    columns_.room[c] *= retreatFactor;
    straightened_[c] += straightenShare*(1 - straightened_[c]);
}


Foam::vectorField Foam::movingColumns::standing(const label c) const
{
    const label n = spacing_.nLayers;
    const vector& axis = front_.visibility.cones[c].axis;
    const scalar s = straightened_[c];
    const vector straight
    (
        columnOffset(front_.visibility, c, axis, maxStretch_)
    );

    vectorField offsets(n);
    for (label i = 0; i < n; ++i)
    {
        offsets[i] = (1 - s)*columns_.offsets[c*n + i] + s*straight;
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


void Foam::movingColumns::stand(const label c, const vectorField& directions)
{
    const label n = spacing_.nLayers;
    straightened_[c] = 0;

    for (label i = 0; i < n; ++i)
    {
        columns_.offsets[c*n + i] = columnOffset
        (
            front_.visibility, c, directions[i], maxStretch_
        );
    }

    build(c);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::movingColumns::movingColumns
(
    const layerFront& front,
    const layerSpacing& spacing,
    const scalar maxStretch,
    layerColumns& columns
)
:
    front_(front),
    spacing_(spacing),
    maxStretch_(maxStretch),
    columns_(columns),
    graph_(makeWallGraph(front.surface, front.addressing)),
    turns_(front.wallPoints.size(), 0),
    straightened_(front.wallPoints.size(), 0),
    leans_(front.wallPoints.size(), 0),
    candidates_(front.surface.faces.size(), true),
    moved_(front.surface.faces.size(), true)
{
    const wallSurface& surface = front.surface;
    layers_.nLayers = spacing.nLayers;
    layers_.faces = surface.faces;
    layers_.patchIDs = SubList<label>(surface.patchIDs, front.nWallFaces);
    layers_.patchNames = surface.patchNames;
    layers_.furtherRoots = front.furtherRoots();
    layers_.points.setSize(surface.points.size()*(spacing.nLayers + 1));

    forAll(surface.points, c)
    {
        build(c);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::movingColumns::hopeless(const label c) const
{
    return columns_.room[c] < hopelessShare*spacing_.thickness[c];
}


Foam::labelList Foam::movingColumns::takeCandidates()
{
    const labelList candidates(findIndices(candidates_, true));
    candidates_ = false;

    return candidates;
}


Foam::boolList Foam::movingColumns::takeMoved()
{
    boolList moved(moved_.size(), false);
    moved.swap(moved_);

    return moved;
}


void Foam::movingColumns::retreat
(
    const labelUList& columns,
    const squeezeCause cause
)
{
    boolList moved(front_.wallPoints.size(), false);

    for (const label c : columns)
    {
        takeBack(c);
        columns_.causes[c] = cause;
        moved[c] = true;
    }

    for
    (
        const label c
      : limitGradient
        (
            front_.surface, front_.addressing, heightSlope, columns_.room
        )
    )
    {
        if (columns_.causes[c] == squeezeCause::none)
        {
            columns_.causes[c] = squeezeCause::neighbour;
        }
        moved[c] = true;
    }

    rebuild(moved);
}


bool Foam::movingColumns::turn(const labelUList& columns)
{
    boolList moved(front_.wallPoints.size(), false);
    bool any = false;

    for (const label c : columns)
    {
        moved[c] = true;

        if (turns_[c] < maxTurns)
        {
            any = true;
            for (const label q : front_.addressing.pointPoints[c])
            {
                moved[q] = true;
            }
        }
    }

    if (!any)
    {
        return false;
    }

    const label n = spacing_.nLayers;
    const labelList turning(findIndices(moved, true));
    vectorField turned(turning.size()*n);

    forAll(turned, k)
    {
        const label c = turning[k/n];
        const vector& own = columns_.offsets[c*n + k % n];
        const vector mean = graph_.mean(columns_.offsets, c, n, k % n);

        // Less so near to the wall, where columns stand upright
        const scalar share = wallGraph::fullPass*::sqrt
        (
            columns_.heights[c*n + k % n]/columns_.heights[c*n + n - 1]
        );

        turned[k] = columnOffset
        (
            front_.visibility, c, own + share*(mean - own), maxStretch_
        );
    }

    forAll(turned, k)
    {
        columns_.offsets[turning[k/n]*n + k % n] = turned[k];
        turns_[turning[k/n]] += k % n == 0;
    }

    rebuild(moved);

    return true;
}


bool Foam::movingColumns::lean
(
    const label c,
    const std::function<scalar(label facei)>& fault
)
{
    if (leans_[c]++ >= maxLeans)
    {
        return false;
    }

    const labelList& faces = front_.addressing.pointFaces[c];
    const auto faults = [&]()
    {
        scalar sum = 0;
        for (const label facei : faces)
        {
            sum += fault(facei);
        }
        return sum;
    };

    const vectorField before(standing(c));
    const scalar asItStands = faults();
    scalar least = leanGain*asItStands;
    vectorField best;

    for (const vectorField& directions : leaning(c))
    {
        stand(c, directions);
        const scalar sum = faults();

        if (sum < least)
        {
            least = sum;
            best = directions;
        }
    }

    stand(c, best.size() ? best : before);

    if (best.empty())
    {
        return false;
    }

    touch(c);

    return true;
}


Foam::scalar Foam::movingColumns::worstJacobian(const label facei) const
{
    scalar worst = GREAT;

    for (label i = 1; i <= layers_.nLayers; ++i)
    {
        worst = min(worst, scaledJacobian(layers_, facei, i));
    }

    return worst;
}


Foam::scalar Foam::movingColumns::jacobianOfRetreat
(
    const label facei,
    const label retreating
)
{
    const scalar room = columns_.room[retreating];
    const scalar straightened = straightened_[retreating];

    takeBack(retreating);
    build(retreating);
    const scalar worst = worstJacobian(facei);

    columns_.room[retreating] = room;
    straightened_[retreating] = straightened;
    build(retreating);

    return worst;
}


// ************************************************************************* //
