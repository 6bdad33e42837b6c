/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hexFaces.H"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The cells of an octree as faces
class hexFaceMaker
{
    const hexOctree& tree_;
    const label depth_;

    //- Cells of leaves, -1 of others; leaves of cells
    labelList cells_;
    DynamicList<label> leaves_;

    std::unordered_map<std::uint64_t, label> labels_;

    polyMeshParts mesh_;

    //- Faces of a patch: the owner, the leaf whose side it is, and the side
    struct boundaryFace
    {
        label owner;
        label leaf;
        label side;
    };
    List<DynamicList<boundaryFace>> boundary_;

    //- The neighbour across a face, the leaf whose side it is, and the side
    struct cellFace
    {
        label neighbour;
        label leaf;
        label side;
    };

    static std::uint64_t key(const labelVector& at)
    {
        return std::uint64_t(at.x()) << 42 | std::uint64_t(at.y()) << 21
          | std::uint64_t(at.z());
    }

    //- Numbers cells along the curve of the octree
    void number(label node);

    //- Adds the corners of all leaves as points, also of leaves that are no
    //  cells: a face of a cell is the side of the leaf beyond the face if that
    //  leaf is smaller
    void addPoints();

    label find(const labelVector& at) const
    {
        const auto found = labels_.find(key(at));
        return found == labels_.end() ? -1 : found->second;
    }

    //- The side of a leaf, seen from outside, with the points on its edges
    face sideOf(label leaf, label side) const;

    //- The leaves beyond a side of a leaf; none at the side of the box
    void addNeighbours
    (
        label leaf,
        label side,
        DynamicList<label>& neighbours
    ) const;

    void addCell(label celli, const labelList& sidePatches);

    void addPatches();

public:

    hexFaceMaker(const hexOctree& tree, const hexCoreBox& box);

    polyMeshParts release() { return std::move(mesh_); }
};


void hexFaceMaker::number(const label node)
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


void hexFaceMaker::addPoints()
{
    DynamicList<point> points(leaves_.size() + leaves_.size()/8);
    labels_.reserve(points.capacity());

    for (label leaf = 0; leaf < tree_.size(); ++leaf)
    {
        if (!tree_.isLeaf(leaf))
        {
            continue;
        }
        const label width = 1 << (depth_ - tree_.level(leaf));

        for (label octant = 0; octant < 8; ++octant)
        {
            labelVector at(width*tree_.at(leaf));
            for (direction d = 0; d < 3; ++d)
            {
                at[d] += width*(octant >> d & 1);
            }
            if (labels_.emplace(key(at), points.size()).second)
            {
                points.append(tree_.pointAt(at));
            }
        }
    }

    mesh_.points.transfer(points);
}


face hexFaceMaker::sideOf(const label leaf, const label side) const
{
    const label width = 1 << (depth_ - tree_.level(leaf));
    const direction d = side/2;
    const direction e = (d + 1) % 3;
    const direction f = (d + 2) % 3;
    labelVector corners[4];

    for (label k = 0; k < 4; ++k)
    {
        // Counter-clockwise seen from the high side
        corners[k] = width*tree_.at(leaf);
        corners[k][d] += width*(side % 2);
        corners[k][e] += width*(k == 1 || k == 2);
        corners[k][f] += width*(k >= 2);
    }
    if (side % 2 == 0)
    {
        std::swap(corners[1], corners[3]);
    }

    DynamicList<label, 8> polygon;
    for (label k = 0; k < 4; ++k)
    {
        const labelVector& a = corners[k];
        const labelVector sum(a + corners[(k + 1) % 4]);
        polygon.append(find(a));

        const label middle = width > 1
          ? find(labelVector(sum.x()/2, sum.y()/2, sum.z()/2)) : -1;
        if (middle >= 0)
        {
            polygon.append(middle);
        }
    }

    return face(polygon);
}


void hexFaceMaker::addNeighbours
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


void hexFaceMaker::addCell(const label celli, const labelList& sidePatches)
{
    DynamicList<cellFace, 24> higher;
    DynamicList<label> neighbours;
    const label leaf = leaves_[celli];

    for (label side = 0; side < 6; ++side)
    {
        neighbours.clear();
        addNeighbours(leaf, side, neighbours);

        if (neighbours.empty())
        {
            boundary_[sidePatches[side]].append
            (
                boundaryFace{celli, leaf, side}
            );
        }
        for (const label other : neighbours)
        {
            const bool isSmaller = tree_.level(other) > tree_.level(leaf);
            const label facing = side ^ 1;
            const label smaller = isSmaller ? other : leaf;
            const label its = isSmaller ? facing : side;

            if (!tree_.isCell(other))
            {
                boundary_.last().append(boundaryFace{celli, smaller, its});
            }
            else if (cells_[other] > celli)
            {
                higher.append(cellFace{cells_[other], smaller, its});
            }
        }
    }

    std::sort
    (
        higher.begin(), higher.end(),
        [](const cellFace& a, const cellFace& b)
        {
            return a.neighbour < b.neighbour;
        }
    );

    for (const cellFace& f : higher)
    {
        face polygon(sideOf(f.leaf, f.side));
        if (f.leaf != leaf)
        {
            polygon.flip();
        }
        mesh_.topology.append(std::move(polygon), celli, f.neighbour);
    }
}


void hexFaceMaker::addPatches()
{
    for (const DynamicList<boundaryFace>& patch : boundary_)
    {
        mesh_.topology.startPatch();
        for (const boundaryFace& f : patch)
        {
            face polygon(sideOf(f.leaf, f.side));
            if (f.leaf != leaves_[f.owner])
            {
                polygon.flip();
            }
            mesh_.topology.append(std::move(polygon), f.owner);
        }
    }
}


hexFaceMaker::hexFaceMaker(const hexOctree& tree, const hexCoreBox& box)
:
    tree_(tree),
    depth_(tree.depth()),
    cells_(tree.size(), -1),
    boundary_(box.patches.names.size() + 1)
{
    const labelVector& n = tree.nRoots();
    for (label root = 0; root < n.x()*n.y()*n.z(); ++root)
    {
        number(root);
    }

    addPoints();
    const labelList sidePatches
    (
        box.sidePatches.size()
      ? box.sidePatches : labelList(6, boundary_.size() - 1)
    );
    mesh_.nCells = leaves_.size();
    mesh_.topology.reserve(4*leaves_.size(), 4*leaves_.size());
    forAll(leaves_, celli)
    {
        addCell(celli, sidePatches);
    }
    addPatches();
    mesh_.patches = box.patches;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

polyMeshParts hexFaces(const hexOctree& tree, const hexCoreBox& box)
{
    return hexFaceMaker(tree, box).release();
}

} // End namespace Foam

// ************************************************************************* //
