/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movingColumns.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Least growth of columns that do not get all back
static const scalar growthFactor = 1.02;

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::movingColumns::columnsBeside(const label c) const
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


bool Foam::movingColumns::grow
(
    const labelUList& columnsOnPoint,
    const std::function<bool(label facei)>& atFault
)
{
    const pointField& points = front_.surface.points;
    scalarField& room = columns_.room;

    scalar largest = GREAT;
    scalar current = 0;

    for (const label c : columnsOnPoint)
    {
        current = max(current, room[c]);
        largest = min(largest, firstRoom_[c]);

        for (const label q : front_.addressing.pointPoints[c])
        {
            if (!columnsOnPoint.found(q))
            {
                const scalar distance = mag(points[q] - points[c]);
                largest = min
                (
                    largest, room[q] + layerColumns::maxSlope*distance
                );
            }
        }
    }

    const scalar grown = min(largest, current/retreatFactor);

    if (grown <= current || grown < min(growthFactor*current, largest))
    {
        return false;
    }

    List<posture> before(columnsOnPoint.size());
    forAll(columnsOnPoint, i)
    {
        before[i] = postureOf(columnsOnPoint[i]);
        room[columnsOnPoint[i]] = grown;
        build(columnsOnPoint[i]);
    }

    for (const label c : columnsOnPoint)
    {
        for (const label facei : front_.addressing.pointFaces[c])
        {
            if (atFault(facei))
            {
                forAll(columnsOnPoint, i)
                {
                    resume(columnsOnPoint[i], before[i]);
                }

                return false;
            }
        }
    }

    for (const label c : columnsOnPoint)
    {
        if (grown == firstRoom_[c])
        {
            columns_.causes[c] = firstCauses_[c];
        }
        touch(c);
    }

    return true;
}


// ************************************************************************* //
