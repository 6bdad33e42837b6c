/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hexPoints.H"
#include "DynamicList.H"

namespace Foam
{

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
