/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "turnColumns.H"
#include "HashSet.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool Foam::turnColumns
(
    layerEditor& editor,
    const labelUList& columns,
    labelList& nTurns
)
{
    const layerMoveControls& controls = editor.controls();
    labelHashSet all(columns);
    bool any = false;

    for (const label c : columns)
    {
        if (nTurns[c] < controls.maxTurns)
        {
            any = true;
            all.insert(editor.front().addressing.pointPoints[c]);
        }
    }

    if (!any)
    {
        return false;
    }

    const label n = editor.spacing().nLayers;
    const labelList turning(all.sortedToc());
    List<vectorField> directions(turning.size());

    #pragma omp parallel for schedule(static, 64) if (turning.size() > 64)
    forAll(turning, k)
    {
        const label c = turning[k];
        directions[k].setSize(n);

        for (label i = 0; i < n; ++i)
        {
            const vector& own = editor.offset(c, i);
            const scalar share = controls.turnShare*editor.turnShare(c, i);

            directions[k][i] =
                own + share*(editor.neighboursOffset(c, i) - own);
        }
    }

    for (const label c : turning)
    {
        ++nTurns[c];
        editor.remember(c);
    }

    #pragma omp parallel for schedule(static, 64) if (turning.size() > 64)
    forAll(turning, k)
    {
        const label c = turning[k];
        editor.setDirections(c, directions[k], editor.straightened(c));
    }

    for (const label c : turning)
    {
        editor.touch(c);
    }

    return true;
}


// ************************************************************************* //
