/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldSizes.H"
#include "farFieldTets.H"
#include "limitGradient.H"
#include "planarColumns.H"

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


//- The mean lengths of the edges in the first of two empty sides, at their
//  points and across
static scalarField meanEdgesInPlane
(
    const wallSurface& outer,
    const wallAddressing& addressing,
    const labelUList& across
)
{
    scalarField sums(across.size(), Zero);
    scalarField numbers(across.size(), Zero);
    for (const edge& e : addressing.edges)
    {
        if (across[e.start()] >= 0 && across[e.end()] >= 0)
        {
            for (const label c : {e.start(), e.end()})
            {
                sums[c] += e.mag(outer.points);
                ++numbers[c];
            }
        }
    }
    forAll(across, c)
    {
        if (across[c] >= 0)
        {
            sums[across[c]] = sums[c];
            numbers[across[c]] = numbers[c];
        }
    }

    return sums/max(numbers, scalar(1));
}


//- Returns the sizes [m] at the points of the outer surface of the layers. They
//  grow along the surface by the growth rate at most.
static scalarField layerSizesOf
(
    const wallSurface& outer,
    const wallAddressing& addressing,
    const labelUList& across,
    const scalar growthRate
)
{
    scalarField sizes
    (
        across.empty()
      ? meanEdges(outer, addressing)
      : meanEdgesInPlane(outer, addressing, across)
    );
    limitGradient(outer, addressing, growthRate - 1, sizes);

    return sizes;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

layerSizes sizesFromLayers
(
    const wallSurface& outer,
    const wallAddressing& addressing,
    const wallBorder& border,
    const labelUList& across,
    const farFieldDomain& domain,
    const farFieldControls& controls
)
{
    const sidePlane* plane =
        across.empty() ? nullptr
      : &border.sides[emptySides(border).first()];
    boundBox box(boundBox::invertedBox);
    for
    (
        const pointField* points :
        {&outer.points, &domain.boundary.surface.points, &domain.core.points}
    )
    {
        for (const point& x : *points)
        {
            box.add(plane ? x - plane->distance(x)*plane->normal : x);
        }
    }
    const scalarField atPoints
    (
        layerSizesOf(outer, addressing, across, controls.growthRate)
    );

    return layerSizes
    {
        atPoints,
        makeSizes(outer.points, atPoints, box, controls, domain.bounds)
    };
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
