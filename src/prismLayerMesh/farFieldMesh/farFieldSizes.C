/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldSizes.H"
#include "farFieldTets.H"
#include "limitGradient.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Sizes at the points of the far boundary that are not on the layers
static scalarField sizesOf(const tetBoundary& far)
{
    const label nCommon = far.columns.size();
    const scalarField sizes
    (
        meanEdges(far.surface, makeWallAddressing(far.surface))
    );

    return scalarField(SubList<scalar>(sizes, sizes.size() - nCommon, nCommon));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalarField layerSizesOf
(
    const wallSurface& outer,
    const wallAddressing& addressing,
    const scalar growthRate
)
{
    scalarField sizes(meanEdges(outer, addressing));
    limitGradient(outer, addressing, growthRate - 1, sizes);

    return sizes;
}


cellSizes sizesFromLayers
(
    const wallSurface& outer,
    const scalarField& sizes,
    const farFieldDomain& domain,
    const farFieldControls& controls
)
{
    boundBox box(outer.points, false);
    box.add(domain.boundary.surface.points);
    box.add(domain.core.points);

    return makeSizes(outer.points, sizes, box, controls, domain.bounds);
}


bool hasOwnSizes(const farFieldControls& controls)
{
    return controls.type == farFieldType::mesh
        || controls.boundary.type == farBoundaryType::surface;
}


std::unique_ptr<const cellSizes> sizesFromBoth
(
    const wallSurface& both,
    scalarField sizes,
    const tetBoundary& far,
    const farFieldDomain& domain,
    const farFieldControls& controls
)
{
    sizes.append(sizesOf(far));

    return std::make_unique<const cellSizes>
    (
        makeSizes
        (
            both.points, sizes, boundBox(both.points, false), controls,
            domain.bounds
        )
    );
}

} // End namespace Foam

// ************************************************************************* //
