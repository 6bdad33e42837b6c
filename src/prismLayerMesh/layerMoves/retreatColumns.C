/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "retreatColumns.H"
#include "HashSet.H"
#include "layerEditor.H"
#include "limitGradient.H"
#include "ranges.H"
#include "scaledJacobian.H"

namespace Foam
{

//- Adds the columns that follow through the bound on the gradient, on all
//  shares: the lowest thickness is the same in any order of steps
static void addFollowing(const layerEditor& editor, Map<scalar>& thickness)
{
    const layerFront& front = editor.front();
    bool anyLower = true;

    while (anyLower)
    {
        followGradient
        (
            front.surface, front.addressing, layerColumns::maxSlope,
            editor.thickness(), thickness
        );

        bool lower = false;
        const Map<scalar> ofOwners(editor.team().columns.ofOwners(thickness));
        forAllConstIters(ofOwners, iter)
        {
            const label c = iter.key();
            if (iter.val() < thickness.lookup(c, editor.thickness()[c]))
            {
                thickness.set(c, iter.val());
                lower = true;
            }
        }
        anyLower = editor.team().any(lower);
    }
}


void retreatColumns
(
    layerEditor& editor,
    const labelUList& columns,
    const squeezeCause cause
)
{
    const layerMoveControls& controls = editor.controls();
    Map<scalar> thickness;

    for (const label c : columns)
    {
        if (editor.mayMove(c))
        {
            thickness.insert(c, controls.retreatFactor*editor.thickness()[c]);
        }
    }
    const labelHashSet retreating(thickness.toc());
    addFollowing(editor, thickness);

    const labelList lowered(editor.team().ownOf(thickness.sortedToc()));
    for (const label c : lowered)
    {
        editor.remember(c);
    }

    #pragma omp parallel for schedule(static, 64) if (lowered.size() > 128)
    forAll(lowered, i)
    {
        const label c = lowered[i];
        editor.setThickness
        (
            c, thickness[c], retreating.found(c) ? controls.straightenShare : 0
        );
    }

    for (const label c : lowered)
    {
        if (retreating.found(c))
        {
            editor.setCause(c, cause);
        }
        else if (editor.causes()[c] == squeezeCause::none)
        {
            editor.setCause(c, squeezeCause::neighbour);
        }
        editor.touch(c);
    }
    editor.publish(lowered);
}


scalar jacobianOfRetreat(layerEditor& editor, const label facei, const label c)
{
    const layerMoveControls& controls = editor.controls();
    const columnState before(editor.state(c));

    editor.setThickness
    (
        c, controls.retreatFactor*before.thickness, controls.straightenShare
    );
    const scalar worst = worstJacobian(editor.layers(), facei);
    editor.restore(c, before);

    return worst;
}


// * * * * * * * * * * * * * * *  Grow Columns * * * * * * * * * * * * * * * //

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
    return anyOf(columns, [&](const label c)
    {
        return anyOf(editor.front().addressing.pointFaces[c], isAtFault);
    });
}


//- Grow columns on one point. False if they stay.
static bool grow
(
    layerEditor& editor,
    const labelUList& columnsOnPoint,
    const std::function<bool(label facei)>& isAtFault
)
{
    const scalar current = max(scalarField(editor.thickness(), columnsOnPoint));
    const scalar largest = largestThickness(editor, columnsOnPoint);
    const scalar grown = min(largest, current/editor.controls().retreatFactor);

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


//- Returns a colour of each point of the wall, at its first column, such that
//  columns on points of one colour are on no common face
static labelList pointColours(const layerEditor& editor)
{
    const layerFront& front = editor.front();
    faceList faces(front.surface.faces);
    for (face& f : faces)
    {
        inplaceRenumber(front.wallPoints, f);
    }

    labelListList pointFaces(front.wallPoints.size());
    forAll(front.wallPoints, c)
    {
        pointFaces[front.wallPoints[c]].append(front.addressing.pointFaces[c]);
    }

    return columnColours(faces, pointFaces, editor.team());
}


//- Grow groups of columns, each on one point. Returns the columns that have
//  grown.
static labelList growTogether
(
    layerEditor& editor,
    const UList<labelList>& groups,
    const std::function<bool(label facei)>& isAtFault
)
{
    const columnTeam& team = editor.team();
    DynamicList<label> grown;

    if (!team.any(groups.size()))
    {
        return labelList();
    }

    const labelList colours(pointColours(editor));
    const label nColours = 1 + max(team.gather(labelList(1, max(colours))));

    for (label colour = 0; colour < nColours; ++colour)
    {
        const label nBefore = grown.size();

        for (const labelList& group : groups)
        {
            if (colours[editor.front().wallPoints[group[0]]] != colour)
            {
                continue;
            }

            List<columnState> before(group.size());
            forAll(group, i)
            {
                before[i] = editor.state(group[i]);
            }
            if (grow(editor, group, isAtFault))
            {
                forAll(group, i)
                {
                    editor.accept(group[i], before[i]);
                }
                grown.append(group);
            }
        }
        editor.publish(SubList<label>(grown, grown.size() - nBefore, nBefore));
    }

    return labelList(std::move(grown));
}


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
    for (const label c : editor.team().ownOf(columns))
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

    grown.insert(growTogether(editor, together, isAtFault));

    return grown.sortedToc();
}

} // End namespace Foam

// ************************************************************************* //
