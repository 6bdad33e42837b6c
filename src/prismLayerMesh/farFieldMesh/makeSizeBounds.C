/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "makeSizeBounds.H"
#include "regionSearch.H"

#include <memory>

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::sizeBounds Foam::makeSizeBounds
(
    const farFieldControls& controls,
    const Time& time
)
{
    const label n = controls.regions.size();
    const auto searches = std::make_shared<PtrList<regionSearch>>(n);

    forAll(controls.regions, i)
    {
        searches->set(i, new regionSearch(controls.regions[i], time));
    }

    return [=](const pointField& points)
    {
        scalarField sizes(points.size(), controls.maxCellSize);

        forAll(*searches, i)
        {
            const scalarField distances((*searches)[i].distances(points));

            sizes = min
            (
                sizes,
                controls.regions[i].cellSize
              + (controls.growthRate - 1)*distances
            );
        }

        return sizes;
    };
}


// ************************************************************************* //
