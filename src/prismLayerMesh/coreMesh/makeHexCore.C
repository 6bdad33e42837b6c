/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeHexCore.H"
#include "hexFaces.H"
#include "error.H"

#include <cmath>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Constants that were tuned
const struct
{
    //- Width of a hexahedron over the size at its centre, at most: at 1 there
    //  are as many faces as without hexahedra, at 1.4 weights are poor
    scalar width = 1.2;

    //- Nodes of the octree for each cell, at most: a seventh is divided, and
    //  those behind the obstacles are no cells
    label nodesPerCell = 2;

    //- Hexahedra of the first level along an edge of the box, at most
    label maxRoots = 1000;

} hexTuned;


} // End anonymous namespace


//- Hexahedra of the first level: nearly cubes, not much wider than the sizes at
//  the corners
static labelVector rootsOf
(
    const boundBox& box,
    const std::function<scalar(const point&)>& size
)
{
    const vector span(box.span());
    const pointField corners(box.points());
    scalar largest = 0;
    for (const point& corner : corners)
    {
        largest = max(largest, size(corner));
    }

    const scalar width = min(cmptMin(span), hexTuned.width*largest);
    labelVector n;
    for (direction d = 0; d < 3; ++d)
    {
        n[d] = min(max(std::ceil(span[d]/width - 1e-9), scalar(1)),
            scalar(hexTuned.maxRoots));
    }

    return n;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

polyMeshParts makeHexCore
(
    const hexCoreBox& box,
    const coreObstacles& obstacles,
    const std::function<scalar(const point&)>& size,
    const label maxCells
)
{
    // Parts of what is clear of the obstacles, and in front, are so
    const auto partsOf = [&](const boundBox& b, bool& isClear)
    {
        const point centre(b.midpoint());

        if (!isClear && !obstacles.surface.overlaps(b))
        {
            isClear = obstacles.fluid.inFront(centre);
            if (!isClear)
            {
                return hexOctree::parts::outside;
            }
        }

        return cmptMax(b.span()) > hexTuned.width*size(centre)
          ? hexOctree::parts::eight : hexOctree::parts::none;
    };
    const hexOctree tree
    (
        box.box, rootsOf(box.box, size), partsOf, hexTuned.nodesPerCell*maxCells
    );

    if (!tree.complete)
    {
        FatalErrorInFunction
            << "The far field needs more hexahedra than farField.maxCells "
            << maxCells << nl
            << "Raise maxCells, growthRate or the cell sizes, or make the wall"
            << " coarser" << exit(FatalError);
    }

    return hexFaces(tree, box);
}

} // End namespace Foam

// ************************************************************************* //
