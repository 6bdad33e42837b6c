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
    sizeBounds bounds;
    bounds.largest = controls.maxCellSize;
    if (controls.regions.empty())
    {
        return bounds;
    }

    const auto searches = std::make_shared<const PtrList<regionSearch>>
    (
        makeSearches(controls.regions, time)
    );

    bounds.atPoints = [=](const pointField& points)
    {
        scalarField sizes(points.size(), GREAT);

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

    return bounds;
}

} // End namespace Foam

// ************************************************************************* //
