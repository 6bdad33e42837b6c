/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeSizeBounds.H"
#include "regionSearch.H"

#include <memory>

namespace Foam
{

sizeBounds makeSizeBounds(const farFieldControls& controls, const Time& time)
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

} // End namespace Foam

// ************************************************************************* //
