/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerEditor.H"
#include "bitSet.H"
#include "DynamicList.H"
#include "Hasher.H"
#include "ListOps.H"

#include <algorithm>
#include <tuple>

namespace Foam
{

static bool isBefore(const label a, const label b)
{
    const unsigned hashA = Hasher(&a, sizeof(a));
    const unsigned hashB = Hasher(&b, sizeof(b));

    return std::tie(hashA, a) < std::tie(hashB, b);
}


//- The colour of a column. -1 if columns before it have none yet.
static label colourOf
(
    const label c,
    const faceList& faces,
    const labelListList& columnFaces,
    const columnTeam& team,
    const labelList& colours
)
{
    DynamicList<label> others;
    for (const label facei : columnFaces[c])
    {
        for (const label q : faces[facei])
        {
            if (colours[q] >= 0)
            {
                others.append(colours[q]);
            }
            else if (isBefore(team.stateColumn(q), team.stateColumn(c)))
            {
                return -1;
            }
        }
    }

    label colour = 0;
    while (others.found(colour))
    {
        ++colour;
    }

    return colour;
}


labelList columnColours
(
    const faceList& faces,
    const labelListList& columnFaces,
    const columnTeam& team
)
{
    labelList colours(columnFaces.size(), -1);
    labelList waiting(team.ownOf(identity(colours.size())));

    while (team.any(waiting.size()))
    {
        labelList found(waiting.size());

        #pragma omp parallel for schedule(static, 256)
        forAll(waiting, i)
        {
            found[i] = colourOf(waiting[i], faces, columnFaces, team, colours);
        }

        UIndirectList<label>(colours, waiting) = found;
        team.columns.update(colours);
        waiting = subsetList
        (
            waiting, [&](const label c) { return colours[c] < 0; }
        );
    }

    return colours;
}

} // End namespace Foam


namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const columnConstraint& layerEditor::constraint(const label c) const
{
    static const columnConstraint free;

    return constraints_.empty() ? free : constraints_[c];
}


scalarList layerEditor::heightsFor(const label c, const scalar thickness) const
{
    scalarList heights(spacing_.nLayers + 1);
    spacing_.setHeights(c, thickness, heights);

    return heights;
}


void layerEditor::setHeights(const label c, const scalarList& heights)
{
    SubList<scalar>(heights_, heights.size(), c*heights.size()) = heights;
}


vector layerEditor::allowedOffset
(
    const label c,
    const label i,
    const vector& direction
) const
{
    const wallVisibility& visibility = front_.visibility;
    const scalar stretch = proposed_.stretch(c, heights(c)[i]);

    if (constraints_.empty())
    {
        return columnOffset(visibility, c, direction, stretch);
    }

    // The cone may turn the direction out of the plane, and the way back into
    // the plane may take height away
    const vector offset
    (
        columnOffset(visibility, c, constraint(c).allowed(direction), stretch)
    );
    const vector allowed(constraint(c).allowed(offset));

    return allowed*visibility.heightCosine(c, offset)
       /max(visibility.heightCosine(c, allowed), SMALL);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

layerEditor::layerEditor
(
    const layerFront& front,
    const layerSpacing& spacing,
    const layerColumns& proposed,
    const layerMoveControls& controls,
    const List<columnConstraint>& constraints,
    const columnTeam& team
)
:
    front_(front),
    spacing_(spacing),
    proposed_(proposed),
    controls_(controls),
    team_(team),
    constraints_(constraints),
    smoother_(front.surface, front.addressing),
    colours_
    (
        columnColours(front.surface.faces, front.addressing.pointFaces, team)
    ),
    nColours_(1 + max(team.gather(labelList(1, max(colours_))))),
    thickness_(proposed.maxThickness),
    causes_(proposed.causes),
    heights_(front.wallPoints.size()*(spacing.nLayers + 1)),
    journal_(identity(front.surface.faces.size()))
{
    const wallSurface& surface = front.surface;
    layers_ = layersWithoutPoints(front, spacing.nLayers);
    layers_.isCut = controls_.isCut;
    layers_.points.setSize(surface.points.size()*(spacing.nLayers + 1));

    #pragma omp parallel for schedule(static, 64)
    forAll(surface.points, c)
    {
        layers_.points[layers_.index(c, 0)] = surface.points[c];
        setHeights(c, heightsFor(c, thickness_[c]));

        for (label i = 1; i <= spacing.nLayers; ++i)
        {
            const scalar h = heights(c)[i];
            const vector offset(proposed.interpolated(proposed.offsets, c, h));
            layers_.points[layers_.index(c, i)] =
                constraint(c).allowedPoint(surface.points[c] + h*offset);
        }
    }

    if (team.hasImages())
    {
        publish(team.ownOf(identity(surface.points.size())));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList layerEditor::columnsBeside(const label c) const
{
    DynamicList<label> columns;
    columns.append(c);

    for (label i = 0; i < columns.size(); ++i)
    {
        for (const label q : front_.addressing.pointPoints[columns[i]])
        {
            if
            (
                front_.wallPoints[q] == front_.wallPoints[c]
             && !columns.found(q)
            )
            {
                columns.append(q);
            }
        }
    }

    return labelList(std::move(columns));
}


vector layerEditor::offsetAt(const label c, const scalar height) const
{
    const scalar* heights = this->heights(c);
    const label n = spacing_.nLayers;
    const label i =
        std::lower_bound(heights + 1, heights + n + 1, height) - heights;

    if (i > n)
    {
        const vectorField& o = proposed_.offsets;
        return offset(c, n) + proposed_.interpolated(o, c, height)
          - proposed_.interpolated(o, c, heights[n]);
    }
    if (i == 1)
    {
        return offset(c, 1);
    }

    const vector lower(offset(c, i - 1));
    const scalar share =
        (height - heights[i - 1])/(heights[i] - heights[i - 1]);

    return lower + share*(offset(c, i) - lower);
}


vector layerEditor::neighboursOffset(const label c, const label i) const
{
    return smoother_.meanOf<vector>
    (
        c, [&](const label q) { return offsetAt(q, heights(c)[i]); }
    );
}


scalar layerEditor::turnShare(const label c, const label i) const
{
    return ::sqrt(heights(c)[i]/spacing_.thickness[c]);
}


columnState layerEditor::state(const label c) const
{
    const label n = spacing_.nLayers;

    return columnState
    {
        pointField(SubList<point>(layers_.points, n, layers_.index(c, 1))),
        thickness_[c],
        causes_[c]
    };
}


void layerEditor::setThickness
(
    const label c,
    const scalar thickness,
    const scalar axisShare
)
{
    if (isFixed(c))
    {
        return;
    }

    const label n = spacing_.nLayers;
    const scalarList heights(heightsFor(c, thickness));
    pointField points(n);
    for (label i = 1; i <= n; ++i)
    {
        const scalar h = heights[i];
        const vector own(offsetAt(c, h));
        const vector axis(proposed_.axisOffset(front_.visibility, c, h));

        points[i - 1] = constraint(c).allowedPoint
        (
            layers_(c, 0) + h*(own + axisShare*(axis - own))
        );
    }

    thickness_[c] = thickness;
    setHeights(c, heights);
    SubList<point>(layers_.points, n, layers_.index(c, 1)) = points;
}


void layerEditor::setDirections
(
    const label c,
    const columnState& before,
    const vectorField& directions,
    const label lowest
)
{
    // A column without height has no direction
    if (isFixed(c) || heights(c)[lowest] <= VSMALL)
    {
        return;
    }

    for (label i = lowest; i <= spacing_.nLayers; ++i)
    {
        const scalar h = heights(c)[i];
        const vector own((before.points[i - 1] - layers_(c, 0))/h);
        const vector placed(own - allowedOffset(c, i, own));
        const bool isKept = mag(placed) <= controls_.maxDisplacement;
        const vector turned(allowedOffset(c, i, directions[i - 1]));

        layers_.points[layers_.index(c, i)] = constraint(c).allowedPoint
        (
            layers_(c, 0) + h*(isKept ? vector(turned + placed) : turned)
        );
    }
}


void layerEditor::setPoint(const label c, const label i, const point& x)
{
    if (!isFixed(c))
    {
        layers_.points[layers_.index(c, i)] = constraint(c).allowedPoint(x);
    }
}


void layerEditor::setCause(const label c, const squeezeCause cause)
{
    if (!isFixed(c))
    {
        causes_[c] = cause;
    }
}

} // End namespace Foam


namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void layerEditor::restore(const label c, const columnState& before)
{
    const label n = spacing_.nLayers;

    SubList<point>(layers_.points, n, layers_.index(c, 1)) = before.points;
    causes_[c] = before.cause;

    if (thickness_[c] != before.thickness)
    {
        thickness_[c] = before.thickness;
        setHeights(c, heightsFor(c, before.thickness));
    }
}


void layerEditor::accept(const label c, const columnState& before)
{
    if (recording_)
    {
        before_.insert(c, before);
    }
    touch(c);
}


void layerEditor::remember(const label c)
{
    if (recording_ && !before_.found(c))
    {
        before_.insert(c, state(c));
    }
}


void layerEditor::touch(const label c)
{
    journal_.append(front_.addressing.pointFaces[c]);
}


void layerEditor::publish(const labelUList& changed)
{
    if (team_.isAlone())
    {
        return;
    }

    const labelHashSet all(changed);
    List<message> toOthers(team_.size());
    forAll(toOthers, p)
    {
        const labelUList& sent = team_.columns.sent()[p];
        columnStates states;
        forAll(sent, i)
        {
            if (all.found(sent[i]))
            {
                states.append(i, state(sent[i]));
            }
        }
        states.addTo(toOthers[p]);
    }

    const List<message> fromOthers(team_.exchange(toOthers));
    forAll(fromOthers, p)
    {
        const columnStates states(fromOthers[p]);
        for (label i = 0; i < states.size(); ++i)
        {
            const label c = team_.columns.received()[p][states.place(i)];
            columnState state(states[i]);
            team_.moveToImage(c, state.points);
            restore(c, state);
            touch(c);
        }
    }
}


labelList layerEditor::inColours
(
    const labelUList& columns,
    const std::function<void()>& prepare,
    const columnChange& change
)
{
    List<DynamicList<label>> groups(nColours_);
    for (const label c : columns)
    {
        if (mayMove(c))
        {
            groups[colours_[c]].append(c);
        }
    }

    DynamicList<label> all;
    for (const labelUList& group : groups)
    {
        List<columnState> before(group.size());
        boolList changed(group.size(), false);
        prepare();

        #pragma omp parallel for schedule(dynamic, 1) if (group.size() > 8)
        forAll(group, i)
        {
            before[i] = state(group[i]);
            changed[i] = change(group[i], before[i]);
        }

        const label nBefore = all.size();
        forAll(group, i)
        {
            if (changed[i])
            {
                accept(group[i], before[i]);
                all.append(group[i]);
            }
        }
        publish(SubList<label>(all, all.size() - nBefore, nBefore));
    }

    sort(all);

    return labelList(std::move(all));
}


labelList layerEditor::allTouchedSince(const label then) const
{
    const SubList<label> since(journal_, journal_.size() - then, then);

    // In proportion to what has changed, unless that is much
    if (since.size() > layers_.faces.size()/16)
    {
        return bitSet(layers_.faces.size(), since).toc();
    }

    labelList faces(since);
    inplaceUniqueSort(faces);

    return faces;
}


labelList layerEditor::touchedSince(const label then) const
{
    return team_.withOwn(allTouchedSince(then), layers_.faces);
}


const stackBoxes& layerEditor::stackGroups()
{
    if (groups_)
    {
        groups_->update(touchedSince(grouped_));
    }
    else
    {
        groups_.reset(new stackBoxes(layers_));
    }
    grouped_ = now();

    return groups_();
}


void layerEditor::record()
{
    recording_ = true;
    before_.clear();
}


void layerEditor::keep()
{
    before_.clear();
}


void layerEditor::rollBack(const label c)
{
    restore(c, before_[c]);
    before_.erase(c);
    touch(c);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::columnStates::columnStates(const message& states)
{
    messageReader reader(states);
    reader(places_, points_, thickness_, causes_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::columnState Foam::columnStates::operator[](const label i) const
{
    const label n = points_.size()/places_.size();

    return columnState
    {
        pointField(SubList<point>(points_, n, i*n)), thickness_[i], causes_[i]
    };
}


void Foam::columnStates::append(const label place, const columnState& state)
{
    places_.append(place);
    points_.append(state.points);
    thickness_.append(state.thickness);
    causes_.append(state.cause);
}


void Foam::columnStates::addTo(message& toOther) const
{
    toOther(places_, points_, thickness_, causes_);
}

// ************************************************************************* //
