/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnsInTheWay.H"
#include "retreatColumns.H"
#include "scaledJacobian.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The column by whose retreat the worst cell of a stack gains most, -1 if no
//  column's retreat helps; columns that are too short are not in the way
static label columnInTheWay(layerEditor& editor, const label facei)
{
    const face& f = editor.layers().faces[facei];
    const scalarField thickness(editor.thickness(), f);
    const scalar least = editor.controls().shortShare*max(thickness);
    scalar largest = worstJacobian(editor.layers(), facei);
    label column = -1;

    forAll(f, k)
    {
        if (thickness[k] > least && !editor.isFixed(f[k]))
        {
            const scalar after = jacobianOfRetreat(editor, facei, f[k]);

            if (after > largest)
            {
                largest = after;
                column = f[k];
            }
        }
    }

    return column;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList tallColumns
(
    const layerEditor& editor,
    const UList<overlappingStack>& stacks
)
{
    boolList tall(editor.thickness().size(), false);

    for (const overlappingStack& stack : stacks)
    {
        const scalar least = editor.controls().tallShare*stack.tallest;
        for (const label c : editor.layers().faces[stack.facei])
        {
            tall[c] = tall[c] || editor.thickness()[c] >= least;
        }
    }
    editor.team().columns.unite(tall);

    return editor.team().ownOf(findIndices(tall, true));
}


labelList columnsInTheWay
(
    layerEditor& editor,
    const labelUList& stacks
)
{
    labelHashSet columns;
    DynamicList<overlappingStack> others;

    for (const label facei : stacks)
    {
        const label c = columnInTheWay(editor, facei);

        if (c < 0)
        {
            others.append
            ({
                facei, tallestOf(editor.layers(), facei, editor.thickness())
            });
        }
        else if (editor.team().isOwn(c))
        {
            columns.insert(c);
        }
    }

    columns.insert(tallColumns(editor, others));

    return columns.sortedToc();
}

} // End namespace Foam

// ************************************************************************* //
