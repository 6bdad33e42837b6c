/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeHexCore.H"
#include "error.H"
#include "hexOctree.H"
#include "meshBuilder.H"

#include <cmath>

namespace Foam
{

namespace
{

//- The cells of an octree as faces
class hexFaceMaker
{
    const hexOctree& tree_;

    //- Cells of leaves, -1 of others; leaves of cells
    labelList cells_;
    DynamicList<label> leaves_;

    hexPoints points_;

    //- The last patch has no name
    const label nPatches_;

    polyMeshParts mesh_;

    meshBuilder faces_;

    //- Numbers cells along the curve of the octree
    void number(const label node)
    {
        if (tree_.isCell(node))
        {
            cells_[node] = leaves_.size();
            leaves_.append(node);
        }
        else if (!tree_.isLeaf(node))
        {
            for (label octant = 0; octant < 8; ++octant)
            {
                number(tree_.children(node) + octant);
            }
        }
    }

    //- The leaves beyond a side of a leaf; none at the side of the box
    void addNeighbours
    (
        const label leaf,
        const label side,
        DynamicList<label>& neighbours
    ) const
    {
        const direction d = side/2;
        labelVector at(tree_.at(leaf));
        at[d] += side % 2 ? 1 : -1;
        const label node = tree_.find(at, tree_.level(leaf));

        if (node < 0 || tree_.isLeaf(node))
        {
            if (node >= 0)
            {
                neighbours.append(node);
            }
            return;
        }

        // The four parts on our side
        for (label octant = 0; octant < 8; ++octant)
        {
            if ((octant >> d & 1) != side % 2)
            {
                neighbours.append(tree_.children(node) + octant);
            }
        }
    }

    //- Adds a face of a cell: a side of its leaf, or of a smaller leaf beyond
    void addFace
    (
        const label celli,
        const label leaf,
        const label side,
        const label second
    )
    {
        face polygon(points_.sideOf(leaf, side));
        if (leaf != leaves_[celli])
        {
            polygon.flip();
        }
        faces_.append(polygon, celli, second);
    }

    //- Adds the faces of a cell on patches, and to cells with higher labels
    void addCell(const label celli, const labelList& sidePatches)
    {
        const label last = meshBuilder::onPatch(nPatches_ - 1);
        DynamicList<label> neighbours;
        const label leaf = leaves_[celli];

        for (label side = 0; side < 6; ++side)
        {
            neighbours.clear();
            addNeighbours(leaf, side, neighbours);

            if (neighbours.empty())
            {
                addFace
                (
                    celli, leaf, side, meshBuilder::onPatch(sidePatches[side])
                );
            }
            for (const label other : neighbours)
            {
                const bool isSmaller = tree_.level(other) > tree_.level(leaf);
                const label second = tree_.isCell(other) ? cells_[other] : last;
                if (second < 0 || second > celli)
                {
                    addFace
                    (
                        celli, isSmaller ? other : leaf,
                        isSmaller ? side ^ 1 : side, second
                    );
                }
            }
        }
    }

public:

    hexFaceMaker(const hexOctree& tree, const hexCoreBox& box)
    :
        tree_(tree),
        cells_(tree.size(), -1),
        points_(tree),
        nPatches_(box.patches.names.size() + 1)
    {
        const labelVector& n = tree.nRoots();
        for (label root = 0; root < n.x()*n.y()*n.z(); ++root)
        {
            number(root);
        }

        mesh_.points = points_.release();
        const labelList sidePatches
        (
            box.sidePatches.size()
          ? box.sidePatches : labelList(6, nPatches_ - 1)
        );
        mesh_.nCells = leaves_.size();
        forAll(leaves_, celli)
        {
            addCell(celli, sidePatches);
        }
        mesh_.topology = faces_.topology
        (
            faces_.order(mesh_.nCells, nPatches_), nPatches_
        );
        mesh_.patches = box.patches;
    }

    polyMeshParts release() { return std::move(mesh_); }
};

} // End anonymous namespace


polyMeshParts hexFaces(const hexOctree& tree, const hexCoreBox& box)
{
    return hexFaceMaker(tree, box).release();
}


// * * * * * * * * * * * * * * *  Make Hex Core  * * * * * * * * * * * * * * //

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
        box.box, rootsOf(box.box, size), partsOf,
        hexTuned.nodesPerCell*maxCells, box.isPeriodic
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
