/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "retreatColumns.H"
#include "HashSet.H"
#include "limitGradient.H"
#include "scaledJacobian.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
            c, thickness[c],
            retreating.found(c) ? controls.straightenShare : 0
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

} // End namespace Foam

// ************************************************************************* //
