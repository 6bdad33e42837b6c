/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "growColumns.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
        largest = min(largest, editor.proposed().maxThickness[c]);

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isLowered(const layerEditor& editor, const label c)
{
    return editor.thickness()[c] < editor.proposed().maxThickness[c];
}


bool growColumns
(
    layerEditor& editor,
    const labelUList& columnsOnPoint,
    const std::function<bool(label facei)>& isAtFault
)
{
    const scalar current =
        max(scalarField(editor.thickness(), columnsOnPoint));
    const scalar largest = largestThickness(editor, columnsOnPoint);
    const scalar grown =
        min(largest, current/editor.controls().retreatFactor);

    if (grown <= current)
    {
        return false;
    }

    List<columnState> before(columnsOnPoint.size());
    forAll(columnsOnPoint, i)
    {
        const label c = columnsOnPoint[i];
        before[i] = editor.state(c);
        editor.setThickness(c, grown);
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

        if (grown == editor.proposed().maxThickness[c])
        {
            editor.setCause(c, editor.proposed().causes[c]);
        }
        editor.accept(c, before[i]);
    }

    return !stays;
}

} // End namespace Foam

// ************************************************************************* //
