/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "growColumns.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Thickness that columns on one point may have, by what was proposed and by
//  the bound on its gradient
static scalar largestThickness
(
    const layerEditor& editor,
    const labelUList& columnsOnPoint
)
{
    const pointField& points = editor.front().surface.points;
    scalar largest = GREAT;

    for (const label c : columnsOnPoint)
    {
        largest = min(largest, editor.proposed().room[c]);

        for (const label q : editor.front().addressing.pointPoints[c])
        {
            if (!columnsOnPoint.found(q))
            {
                const scalar distance = mag(points[q] - points[c]);
                largest = min
                (
                    largest,
                    editor.thickness()[q] + layerColumns::maxSlope*distance
                );
            }
        }
    }

    return largest;
}


static bool anyAtFault
(
    const layerEditor& editor,
    const labelUList& columns,
    const std::function<bool(label facei)>& isAtFault
)
{
    for (const label c : columns)
    {
        const labelList& faces = editor.front().addressing.pointFaces[c];

        if (std::any_of(faces.begin(), faces.end(), isAtFault))
        {
            return true;
        }
    }

    return false;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool Foam::isLowered(const layerEditor& editor, const label c)
{
    return editor.thickness()[c] < editor.proposed().room[c];
}


bool Foam::growColumns
(
    layerEditor& editor,
    const labelUList& columnsOnPoint,
    const std::function<bool(label facei)>& isAtFault
)
{
    const layerMoveControls& controls = editor.controls();
    const scalar current =
        max(scalarField(editor.thickness(), columnsOnPoint));
    const scalar largest = largestThickness(editor, columnsOnPoint);
    const scalar grown = min(largest, current/controls.retreatFactor);

    if
    (
        grown <= current
     || grown < min(controls.growthFactor*current, largest)
    )
    {
        return false;
    }

    List<columnState> before(columnsOnPoint.size());
    forAll(columnsOnPoint, i)
    {
        const label c = columnsOnPoint[i];
        before[i] = editor.state(c);
        editor.setThickness(c, grown, before[i].straightened);
    }

    const bool stays = anyAtFault(editor, columnsOnPoint, isAtFault);

    forAll(columnsOnPoint, i)
    {
        const label c = columnsOnPoint[i];

        if (stays)
        {
            editor.restore(c, before[i]);
            continue;
        }

        if (grown == editor.proposed().room[c])
        {
            editor.setCause(c, editor.proposed().causes[c]);
        }
        editor.accept(c, before[i]);
    }

    return !stays;
}


// ************************************************************************* //
