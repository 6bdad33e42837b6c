/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "growColumns.H"
#include "HashSet.H"

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


//- Grow columns on one point. False if they stay.
static bool grow
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
        before[i] = editor.state(columnsOnPoint[i]);
        editor.setThickness(columnsOnPoint[i], grown);
    }

    const bool stay = anyAtFault(editor, columnsOnPoint, isAtFault);

    forAll(columnsOnPoint, i)
    {
        const label c = columnsOnPoint[i];

        if (stay)
        {
            editor.restore(c, before[i]);
        }
        else if (grown == editor.proposed().maxThickness[c])
        {
            editor.setCause(c, editor.proposed().causes[c]);
        }
    }

    return !stay;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isLowered(const layerEditor& editor, const label c)
{
    return editor.thickness()[c] < editor.proposed().maxThickness[c];
}


labelList growColumns
(
    layerEditor& editor,
    const labelUList& columns,
    const std::function<bool(label facei)>& isAtFault
)
{
    DynamicList<label> alone;
    DynamicList<labelList> together;
    labelHashSet found;
    for (const label c : columns)
    {
        const labelList all(editor.columnsBeside(c));

        if (all.size() == 1)
        {
            alone.append(c);
        }
        else if (found.insert(min(all)))
        {
            together.append(all);
        }
    }

    labelHashSet grown
    (
        editor.inColours
        (
            alone,
            []() {},
            [&](const label c, const columnState&)
            {
                return grow(editor, labelList(1, c), isAtFault);
            }
        )
    );

    for (const labelList& all : together)
    {
        List<columnState> before(all.size());
        forAll(all, i)
        {
            before[i] = editor.state(all[i]);
        }

        if (grow(editor, all, isAtFault))
        {
            forAll(all, i)
            {
                editor.accept(all[i], before[i]);
            }
            grown.insert(all);
        }
    }

    return grown.sortedToc();
}

} // End namespace Foam

// ************************************************************************* //
