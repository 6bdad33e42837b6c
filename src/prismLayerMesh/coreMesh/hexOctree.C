/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hexOctree.H"
#include "DynamicList.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

label hexOctree::child
(
    const node& n,
    const labelVector& at,
    const label level
) const
{
    const label shift = level - n.level - 1;
    label octant = 0;
    for (direction d = 0; d < 3; ++d)
    {
        octant |= (at[d] >> shift & 1) << d;
    }

    return n.children + octant;
}


void hexOctree::divide(const label i)
{
    nodes_[i].children = nodes_.size();
    const label level = nodes_[i].level + 1;

    for (label octant = 0; octant < 8; ++octant)
    {
        labelVector at(2*nodes_[i].at);
        for (direction d = 0; d < 3; ++d)
        {
            at[d] += octant >> d & 1;
        }
        nodes_.append(node{-1, level, at, false, nodes_[i].mark});
    }
    depth_ = max(depth_, level);
}


labelVector hexOctree::opposite
(
    labelVector at,
    const label level,
    const direction d
) const
{
    const label last = (nRoots_[d] << level) - 1;
    if (isPeriodic_[d] && (at[d] == 0 || at[d] == last))
    {
        at[d] = last - at[d];
    }

    return at;
}


void hexOctree::makePeriodic(const label first, List<parts>& wanted) const
{
    for (direction d = 0; d < 3; ++d)
    {
        forAll(wanted, i)
        {
            const node& n = nodes_[first + i];
            const label j = find(opposite(n.at, n.level, d), n.level) - first;
            if (wanted[i] != wanted[j])
            {
                const bool isEight =
                    wanted[i] == parts::eight || wanted[j] == parts::eight;
                wanted[i] = wanted[j] = isEight ? parts::eight : parts::none;
            }
        }
    }
}


void hexOctree::divideAll(const division& parts, const label maxNodes)
{
    for (label first = 0; complete && first < nodes_.size();)
    {
        const label end = nodes_.size();
        List<hexOctree::parts> wanted(end - first);

        #pragma omp parallel for schedule(dynamic, 64)
        forAll(wanted, i)
        {
            wanted[i] = parts(boxOf(first + i), nodes_[first + i].mark);
        }
        if (isPeriodic_.found(true))
        {
            makePeriodic(first, wanted);
        }

        forAll(wanted, i)
        {
            const label level = nodes_[first + i].level + 1;
            nodes_[first + i].outside = wanted[i] == parts::outside;

            if (complete && wanted[i] == parts::eight)
            {
                complete =
                    nodes_.size() + 8 <= maxNodes
                 && cmptMax(nRoots_) < maxCounts >> level;
                if (complete)
                {
                    divide(first + i);
                }
            }
        }

        first = end;
    }
}


label hexOctree::divideTo
(
    const labelVector& at,
    const label level,
    List<DynamicList<label>>& divided
)
{
    label n = find(at, level);
    while (n >= 0 && isCell(n) && nodes_[n].level < level)
    {
        divided[nodes_[n].level].append(n);
        divide(n);
        n = child(nodes_[n], at, level);
    }

    return n;
}


void hexOctree::balance()
{
    // Where a node has parts, all nodes around it are of its level at least
    List<DynamicList<label>> divided(depth_ + 1);
    forAll(nodes_, i)
    {
        if (!isLeaf(i))
        {
            divided[nodes_[i].level].append(i);
        }
    }

    for (label level = depth_; level >= 0; --level)
    {
        // The list grows
        for (label i = 0; i < divided[level].size(); ++i)
        {
            const labelVector centre(nodes_[divided[level][i]].at);

            for (label k = 0; k < 27; ++k)
            {
                const labelVector at
                (
                    centre + labelVector(k % 3 - 1, k/3 % 3 - 1, k/9 - 1)
                );
                divideTo(at, level, divided);
            }
            for (direction d = 0; d < 3; ++d)
            {
                const labelVector at(opposite(centre, level, d));
                const label n = divideTo(at, level, divided);
                if (isCell(n))
                {
                    divided[level].append(n);
                    divide(n);
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

hexOctree::hexOctree
(
    const boundBox& box,
    const labelVector& nRoots,
    const division& parts,
    const label maxNodes,
    const FixedList<bool, 3>& isPeriodic
)
:
    box_(box),
    nRoots_(nRoots),
    isPeriodic_(isPeriodic)
{
    for (label i = 0; i < nRoots.x(); ++i)
    {
        for (label j = 0; j < nRoots.y(); ++j)
        {
            for (label k = 0; k < nRoots.z(); ++k)
            {
                nodes_.append(node{-1, 0, labelVector(i, j, k), false, false});
            }
        }
    }

    complete = nodes_.size() <= maxNodes;
    divideAll(parts, maxNodes);
    balance();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label hexOctree::find(const labelVector& at, const label level) const
{
    labelVector root;
    for (direction d = 0; d < 3; ++d)
    {
        if (at[d] < 0 || at[d] >= nRoots_[d] << level)
        {
            return -1;
        }
        root[d] = at[d] >> level;
    }

    label i = (root.x()*nRoots_.y() + root.y())*nRoots_.z() + root.z();
    while (!isLeaf(i) && nodes_[i].level < level)
    {
        i = child(nodes_[i], at, level);
    }

    return i;
}


point hexOctree::pointAt(const labelVector& at) const
{
    point x(box_.max());
    for (direction d = 0; d < 3; ++d)
    {
        const label n = nRoots_[d] << depth_;
        if (at[d] < n)
        {
            x[d] = box_.min()[d] + box_.span()[d]*at[d]/n;
        }
    }

    return x;
}


boundBox hexOctree::boxOf(const label i) const
{
    const node& n = nodes_[i];
    point low, high;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar width = box_.span()[d]/(nRoots_[d] << n.level);
        low[d] = box_.min()[d] + n.at[d]*width;
        high[d] = box_.min()[d] + (n.at[d] + 1)*width;
    }

    return boundBox(low, high);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

hexPoints::hexPoints(const hexOctree& tree)
:
    tree_(tree)
{
    label nCells = 0;
    for (label leaf = 0; leaf < tree_.size(); ++leaf)
    {
        nCells += tree_.isCell(leaf);
    }
    DynamicList<point> points(nCells + nCells/8);
    labels_.reserve(points.capacity());

    for (label leaf = 0; leaf < tree_.size(); ++leaf)
    {
        if (!tree_.isLeaf(leaf))
        {
            continue;
        }
        const label width = widthOf(leaf);

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

    points_.transfer(points);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

face hexPoints::sideOf(const label leaf, const label side) const
{
    const label width = widthOf(leaf);
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

} // End namespace Foam

// ************************************************************************* //
