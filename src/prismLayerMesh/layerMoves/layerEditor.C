/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerEditor.H"
#include "geometricHeights.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void layerEditor::updateHeights(const label c)
{
    const label n = spacing_.nLayers;
    SubList<scalar> heights(heights_, n + 1, c*(n + 1));

    spacing_.setHeights(c, thickness_[c], heights);
}


vector layerEditor::standing(const label c, const scalar height) const
{
    const scalar s = straightened_[c];

    return (1 - s)*proposed_.interpolated(offsets_, c, height)
      + s*proposed_.axisOffset(front_.visibility, c, height);
}


vector layerEditor::allowedOffset
(
    const label c,
    const label i,
    const vector& direction
) const
{
    const wallVisibility& visibility = front_.visibility;
    const scalar stretch =
        proposed_.stretch(c, proposed_.heights[c*spacing_.nLayers + i]);

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
       /max(visibility.heightCosine(c, allowed), VSMALL);
}


void layerEditor::build(const label c, const label lowest)
{
    const scalar* heights = this->heights(c);

    for (label i = lowest; i <= spacing_.nLayers; ++i)
    {
        layers_.points[layers_.index(c, i)] = constraint(c).allowedPoint
        (
            front_.surface.points[c] + heights[i]*standing(c, heights[i])
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

layerEditor::layerEditor
(
    const layerFront& front,
    const layerSpacing& spacing,
    const layerColumns& proposed,
    const layerMoveControls& controls,
    const List<columnConstraint>& constraints
)
:
    front_(front),
    spacing_(spacing),
    proposed_(proposed),
    controls_(controls),
    constraints_(constraints),
    smoother_(front.surface, front.addressing),
    colours_(columnColours(front.surface.faces, front.addressing)),
    offsets_(proposed.offsets),
    straightened_(front.wallPoints.size(), 0),
    thickness_(proposed.maxThickness),
    causes_(proposed.causes),
    heights_(front.wallPoints.size()*(spacing.nLayers + 1)),
    journal_(identity(front.surface.faces.size()))
{
    const wallSurface& surface = front.surface;
    layers_.nLayers = spacing.nLayers;
    layers_.faces = surface.faces;
    layers_.patchIDs = SubList<label>(surface.patchIDs, front.nWallFaces);
    layers_.patchNames = surface.patchNames;
    layers_.patchTypes = surface.patchTypes;
    layers_.border = surface.border;
    layers_.extraColumnPoints = front.extraColumnPoints();
    layers_.points.setSize(surface.points.size()*(spacing.nLayers + 1));

    #pragma omp parallel for schedule(static, 64)
    forAll(surface.points, c)
    {
        layers_.points[layers_.index(c, 0)] = surface.points[c];
        updateHeights(c);
        build(c);
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


vector layerEditor::straightenedOffset(const label c, const label i) const
{
    const scalar s = straightened_[c];

    return (1 - s)*offset(c, i)
      + s*proposed_.axisOffset
        (
            front_.visibility, c, proposed_.heights[c*spacing_.nLayers + i]
        );
}


scalar layerEditor::turnShare(const label c, const label i) const
{
    const label n = spacing_.nLayers;

    return ::sqrt(proposed_.heights[c*n + i]/proposed_.heights[c*n + n - 1]);
}


columnState layerEditor::state(const label c) const
{
    const label n = spacing_.nLayers;

    return columnState
    {
        pointField(SubList<point>(layers_.points, n, layers_.index(c, 1))),
        vectorField(SubList<vector>(offsets_, n, c*n)),
        straightened_[c],
        thickness_[c],
        causes_[c]
    };
}


void layerEditor::setThickness
(
    const label c,
    const scalar thickness,
    const scalar straightened
)
{
    if (!isFixed(c))
    {
        thickness_[c] = thickness;
        straightened_[c] = straightened;
        updateHeights(c);
        build(c);
    }
}


void layerEditor::setDirections
(
    const label c,
    const vectorField& directions,
    const scalar straightened,
    const label lowest
)
{
    if (isFixed(c))
    {
        return;
    }

    const label n = spacing_.nLayers;
    straightened_[c] = straightened;

    // Offsets are for the heights asked for
    const label above = proposed_.layerAt(c, heights(c)[lowest - 1]);

    for (label i = max(above - 1, 0); i < n; ++i)
    {
        offsets_[c*n + i] = allowedOffset(c, i, directions[i]);
    }

    build(c, max(lowest - 1, 1));
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

// ************************************************************************* //
