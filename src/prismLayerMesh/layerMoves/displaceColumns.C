/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "displaceColumns.H"
#include "ListOps.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Displace own columns at a level by their shares
static void displace
(
    const vectorField& displacements,
    const fittedWall& fitted,
    const displacementShare& share,
    const label level,
    layerEditor& editor
)
{
    forAll(displacements, p)
    {
        const vector& d = displacements[p];
        const label c = fitted.ownColumns[p];

        if (c >= 0 && magSqr(d) > 0)
        {
            const scalar height = editor.heights(c)[level];
            const scalar ofLevel = share(c, height)
               /max(excessOf(editor.controls(), d, height), scalar(1));

            editor.setPoint(c, level, editor.layers()(c, level) + ofLevel*d);
        }
    }
}


//- The own columns that are mobile
static labelList mobileColumns(const fittedWall& fitted)
{
    DynamicList<label> columns;
    forAll(fitted.ownColumns, p)
    {
        if (fitted.ownColumns[p] >= 0 && fitted.mobilities[p] > 0)
        {
            columns.append(fitted.ownColumns[p]);
        }
    }

    return labelList(std::move(columns));
}


//- The levels at which mobile columns have a share
static labelList levelsOf
(
    const layerEditor& editor,
    const labelUList& mobile,
    const displacementShare& share
)
{
    DynamicList<label> levels;

    for (label i = 1; i <= editor.spacing().nLayers; ++i)
    {
        const bool any = anyOf(mobile, [&](const label c)
        {
            return share(c, editor.heights(c)[i])
                 > editor.controls().leftOutShare;
        });
        if (any)
        {
            levels.append(i);
        }
    }

    labelList all(editor.team().gather(levels));
    inplaceUniqueSort(all);

    return all;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar excessOf
(
    const layerMoveControls& controls,
    const vector& displacement,
    const scalar height
)
{
    return mag(displacement)/(controls.maxDisplacement*height);
}


void displaceColumns
(
    const fittedWall& fitted,
    const heightFit& heights,
    const displacementShare& share,
    const std::function<scalarField(label level)>& missing,
    layerEditor& editor
)
{
    const labelList columns(mobileColumns(fitted));
    const labelList levels(levelsOf(editor, columns, share));
    List<scalarField> missingAt(levels.size());
    forAll(levels, k)
    {
        missingAt[k] = missing(levels[k]);
    }

    for (const label c : columns)
    {
        editor.remember(c);
        editor.touch(c);
    }

    #pragma omp parallel for schedule(dynamic, 1)
    forAll(levels, k)
    {
        displace
        (
            heights.displacements(missingAt[k]), fitted, share, levels[k],
            editor
        );
        missingAt[k].clear();
    }
    editor.publish(columns);
}

} // End namespace Foam

// ************************************************************************* //
