/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faultRollBack.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

labelList faultRollBack::faultyFaces(const stackFault first)
{
    const labelList moved(editor_.touchedSince(judged_));
    judged_ = editor_.now();
    DynamicList<label> faulty;

    for (const faultyStack& stack : judge_.findFaults(moved, first))
    {
        const bool isOutside = stack.fault == stackFault::centreOutside;
        if (!isOutside || !tolerated_.test(stack.facei))
        {
            faulty.append(stack.facei);
        }
    }
    for
    (
        const overlappingStack& stack
      : judge_.findOverlapping
        (
            moved, editor_.stackGroups(), editor_.thickness()
        )
    )
    {
        faulty.append(stack.facei);
    }

    return labelList(std::move(faulty));
}


labelList faultRollBack::columnsAtFault(const labelUList& faulty) const
{
    const columnTeam& team = editor_.team();
    boolList atFault(barred.size(), false);
    UIndirectList<bool>(atFault, editor_.layers().columnsOf(faulty)) = true;
    team.columns.unite(atFault);

    return team.ownOf(findIndices(atFault, true));
}


void faultRollBack::rollBack(const label c, DynamicList<label>& rolledBack)
{
    for (const label q : editor_.columnsBeside(c))
    {
        if (editor_.isChanged(q))
        {
            editor_.rollBack(q);
            barred[q] = true;
            rolledBack.append(q);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

faultRollBack::faultRollBack
(
    layerEditor& editor,
    const layerJudge& judge,
    const bitSet& tolerated
)
:
    editor_(editor),
    judge_(judge),
    tolerated_(tolerated),
    judged_(editor.now()),
    barred(editor.thickness().size(), false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool faultRollBack::isAtFault(const label facei) const
{
    return judge_.faultOf
    (
        facei, stackFault::belowAttainable, stackFault::notPositive
    ) != stackFault::none;
}


labelList faultRollBack::notBarredOf(const labelUList& stacks) const
{
    return subsetList
    (
        editor_.team().ownOf(editor_.layers().columnsOf(stacks)),
        [&](const label c) { return !barred[c]; }
    );
}


void faultRollBack::settle(const stackFault first)
{
    // What is rolled back may be in the way of what is not
    for
    (
        labelList faulty(faultyFaces(first));
        editor_.team().any(faulty.size());
        faulty = faultyFaces(stackFault::belowAttainable)
    )
    {
        DynamicList<label> rolledBack;
        for (const label c : columnsAtFault(faulty))
        {
            if (editor_.isChanged(c))
            {
                rollBack(c, rolledBack);
            }
        }
        editor_.publish(rolledBack);
    }

    editor_.keep();
}

} // End namespace Foam

// ************************************************************************* //
