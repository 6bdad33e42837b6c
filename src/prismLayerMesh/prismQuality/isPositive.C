/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellPredicates.H"
#include "layerCell.H"
#include "prismQuality.H"
#include "tetSigns.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A prism; in layer 1 on a triangle without area one of which two or three
//  lower points are one
static bool isPositiveOnTriangle(const layerCell& cell, const bool hasArea)
{
    const point* p[6];

    for (label k = 0; k < 3; ++k)
    {
        p[k] = hasArea ? &cell.lower(k) : &cell.root(k);
        p[k + 3] = &cell.upper(k);
    }

    return hasArea ? isPositivePrism(p) : isPositiveCollapsedPrism(p);
}


//- Layer 1 on a quadrilateral without area: a prism that lies on an edge of the
//  wall, between the triangles at the edge's ends
static bool isPositiveOnEdge(const layerCell& cell)
{
    // From the first point to the second are two columns on one point
    const label k = &cell.root(0) == &cell.root(1) ? 0 : 3;

    const point* p[6] =
    {
        &cell.root(k), &cell.upper(k), &cell.upper((k + 1)%4),
        &cell.root((k + 2)%4), &cell.upper((k + 3)%4), &cell.upper((k + 2)%4)
    };

    return isPositiveLyingPrism(p);
}


static bool hasPositiveCorners(const layerCell& cell)
{
    const label n = cell.size();

    for (label k = 0; k < n; ++k)
    {
        const label next = (k + 1)%n;
        const label prev = (k + n - 1)%n;

        const point& a = cell.lower(k);
        const point& b = cell.upper(k);

        const point* p[6] =
        {
            &a, &cell.lower(next), &cell.lower(prev),
            &b, &cell.upper(next), &cell.upper(prev)
        };

        const tetSigns positive(p, 6);

        if
        (
            !positive(a, *p[1], *p[2], b)
         || !positive(a, b, *p[4], *p[5])
        )
        {
            return false;
        }
    }

    return true;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isPositive(const prismLayers& layers, const label facei, const label i)
{
    const layerCell cell(layers, facei, i);
    const bool hasArea = i > 1 || facei < layers.nWallFaces();

    if (cell.size() == 3)
    {
        return isPositiveOnTriangle(cell, hasArea);
    }

    return hasArea ? hasPositiveCorners(cell) : isPositiveOnEdge(cell);
}

} // End namespace Foam

// ************************************************************************* //
