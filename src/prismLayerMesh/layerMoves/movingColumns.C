/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movingColumns.H"
#include "limitGradient.H"
#include "prismQuality.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- How often a column turns to its neighbours before it retreats
static const label maxTurns = 3;

//- What it takes of the way back to the axis of the visibility cone
static const scalar straightenShare = 0.25;

//- What is left of the height of a column when there is no hope for it
static const scalar hopelessShare = 1e-9;


//- Colours of columns such that those on one face differ
static labelList columnColours
(
    const faceList& faces,
    const wallAddressing& addressing
)
{
    labelList colours(addressing.pointFaces.size(), -1);
    DynamicList<label> others;

    forAll(colours, c)
    {
        others.clear();
        for (const label facei : addressing.pointFaces[c])
        {
            for (const label q : faces[facei])
            {
                others.append(colours[q]);
            }
        }

        label colour = 0;
        while (others.found(colour))
        {
            ++colour;
        }
        colours[c] = colour;
    }

    return colours;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::scalar* Foam::movingColumns::heightsOf(const label c)
{
    const label n = spacing_.nLayers;
    SubList<scalar> heights(heights_, n + 1, c*(n + 1));

    if (heightsRoom_[c] != columns_.room[c])
    {
        heightsRoom_[c] = columns_.room[c];
        layerHeights
        (
            n,
            spacing_.firstThickness[c],
            spacing_.ratio[c],
            columns_.room[c],
            heights
        );
    }

    return heights.cdata();
}


void Foam::movingColumns::build(const label c, label i)
{
    const label n = spacing_.nLayers;
    const wallVisibility& visibility = front_.visibility;
    const scalar* heights = heightsOf(c);

    const scalar s = straightened_[c];

    for (; i <= n; ++i)
    {
        layers_.points[layers_.index(c, i)] = front_.surface.points[c]
          + heights[i]
           *(
                (1 - s)*columns_.offset(c, heights[i])
              + s*columns_.axisOffset(visibility, c, heights[i])
            );
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


void Foam::movingColumns::rebuild(const labelUList& columns)
{
    #pragma omp parallel for schedule(static, 64) \
        if (columns.size() > 128)
    forAll(columns, i)
    {
        build(columns[i]);
    }

    for (const label c : columns)
    {
        touch(c);
    }
}


void Foam::movingColumns::takeBack(const label c)
{
    columns_.room[c] *= retreatFactor;
    straightened_[c] += straightenShare*(1 - straightened_[c]);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::movingColumns::movingColumns
(
    const layerFront& front,
    const layerSpacing& spacing,
    layerColumns& columns
)
:
    front_(front),
    spacing_(spacing),
    columns_(columns),
    firstRoom_(columns.room),
    firstCauses_(columns.causes),
    graph_(front.surface, front.addressing),
    heights_(front.wallPoints.size()*(spacing.nLayers + 1)),
    heightsRoom_(front.wallPoints.size(), -1),
    turns_(front.wallPoints.size(), 0),
    straightened_(front.wallPoints.size(), 0),
    leans_(front.wallPoints.size(), 0),
    maxLeans_(10),
    colours_(columnColours(front.surface.faces, front.addressing)),
    candidates_(front.surface.faces.size(), true),
    moved_(front.surface.faces.size(), true)
{
    const wallSurface& surface = front.surface;
    layers_.nLayers = spacing.nLayers;
    layers_.faces = surface.faces;
    layers_.patchIDs = SubList<label>(surface.patchIDs, front.nWallFaces);
    layers_.patchNames = surface.patchNames;
    layers_.extraColumnPoints = front.extraColumnPoints();
    layers_.points.setSize(surface.points.size()*(spacing.nLayers + 1));

    rebuild(identity(surface.points.size()));
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

    columns_.nRetreats += columns.size();

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
            front_.surface, front_.addressing, layerColumns::maxSlope,
            columns_.room
        )
    )
    {
        if (columns_.causes[c] == squeezeCause::none)
        {
            columns_.causes[c] = squeezeCause::neighbour;
        }
        moved[c] = true;
    }

    rebuild(findIndices(moved, true));
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

    #pragma omp parallel for schedule(static, 64) \
        if (turned.size() > 512)
    forAll(turned, k)
    {
        const label c = turning[k/n];
        const vector& own = columns_.offsets[c*n + k % n];
        const vector mean = graph_.mean(columns_.offsets, c, n, k % n);

        // Less so near to the wall, where columns stand upright
        const scalar share = wallSmoother::fullPass*::sqrt
        (
            columns_.heights[c*n + k % n]/columns_.heights[c*n + n - 1]
        );

        turned[k] = columnOffset
        (
            front_.visibility, c, own + share*(mean - own),
            columns_.stretch(c, columns_.heights[c*n + k % n])
        );
    }

    forAll(turned, k)
    {
        columns_.offsets[turning[k/n]*n + k % n] = turned[k];
        turns_[turning[k/n]] += k % n == 0;
    }

    rebuild(turning);

    return true;
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
    const scalar worst = worstJacobian(layers_, facei);

    columns_.room[retreating] = room;
    straightened_[retreating] = straightened;
    build(retreating);

    return worst;
}


// ************************************************************************* //
