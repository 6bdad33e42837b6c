/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnColours.H"
#include "DynamicList.H"
#include "Hasher.H"

#include <tuple>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static bool isBefore(const label a, const label b)
{
    const unsigned hashA = Hasher(&a, sizeof(a));
    const unsigned hashB = Hasher(&b, sizeof(b));

    return std::tie(hashA, a) < std::tie(hashB, b);
}


//- The colour of a column. -1 if columns before it have none yet.
static label colourOf
(
    const label c,
    const faceList& faces,
    const labelListList& columnFaces,
    const columnTeam& team,
    const labelList& colours
)
{
    DynamicList<label> others;

    for (const label facei : columnFaces[c])
    {
        for (const label q : faces[facei])
        {
            if (colours[q] >= 0)
            {
                others.append(colours[q]);
            }
            else if (isBefore(team.wholeColumn(q), team.wholeColumn(c)))
            {
                return -1;
            }
        }
    }

    label colour = 0;
    while (others.found(colour))
    {
        ++colour;
    }

    return colour;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList columnColours
(
    const faceList& faces,
    const labelListList& columnFaces,
    const columnTeam& team
)
{
    labelList colours(columnFaces.size(), -1);
    labelList waiting(team.ownOf(identity(colours.size())));

    while (team.any(waiting.size()))
    {
        labelList found(waiting.size());

        #pragma omp parallel for schedule(static, 256)
        forAll(waiting, i)
        {
            found[i] = colourOf
            (
                waiting[i], faces, columnFaces, team, colours
            );
        }

        UIndirectList<label>(colours, waiting) = found;
        team.columns.update(colours);
        waiting = subsetList
        (
            waiting, [&](const label c) { return colours[c] < 0; }
        );
    }

    return colours;
}

} // End namespace Foam

// ************************************************************************* //
