/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "monotoneField.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Free points whose values exceed all those of their neighbours, or fall
//  below, by more than tolerance
static boolList extremaOf
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const scalar tolerance
)
{
    scalarField smallest(field.size(), GREAT), largest(field.size(), -GREAT);

    for (const edge& e : mesh.edges)
    {
        for (const label p : {e.start(), e.end()})
        {
            const scalar other = field[e.otherVertex(p)];
            smallest[p] = min(smallest[p], other);
            largest[p] = max(largest[p], other);
        }
    }

    boolList extrema(field.size(), false);
    forAll(extrema, p)
    {
        extrema[p] = mesh.free[p] && smallest[p] <= largest[p]
         && (
                field[p] > largest[p] + tolerance
             || field[p] < smallest[p] - tolerance
            );
    }

    return extrema;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

monotoneField makeMonotoneField
(
    const backgroundMesh& mesh,
    scalarField edgeWeights,
    const fieldControls& controls
)
{
    monotoneField field;
    bool changed = true;

    while (changed)
    {
        field.values = makeHarmonicField(mesh, edgeWeights, controls);
        const boolList extrema
        (
            extremaOf(mesh, field.values, controls.tolerance)
        );
        changed = false;

        forAll(mesh.edges, e)
        {
            const edge& ends = mesh.edges[e];

            if
            (
                edgeWeights[e] < 0
             && (extrema[ends.start()] || extrema[ends.end()])
            )
            {
                edgeWeights[e] = 0;
                ++field.nClipped;
                changed = true;
            }
        }
    }

    return field;
}

} // End namespace Foam

// ************************************************************************* //
