/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sharpLines.H"
#include "searchTree.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A face is along a plane if the product of their unit normals is larger
static constexpr scalar alongCosine = 0.9;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sharpLines::sharpLines(const wallSurface& surface, const scalar minCos)
{
    const vectorField normals(surface.faceNormals());
    const wallSides sides(makeWallSides(surface));
    DynamicList<edge> sharp;
    DynamicList<Pair<vector>> both;

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> all(sides.on(e));
        Pair<vector> n(Zero, Zero);

        if (all.size() == 2)
        {
            n.first() = normals[all[0].facei];
            n.second() = normals[all[1].facei];

            // Normals of neighbours may be opposite to each other
            if (mag(n.first() & n.second()) >= minCos)
            {
                continue;
            }
        }

        sharp.append(edge(all[0].low, all[0].high));
        both.append(n);
    }

    edges_ = edgeList(std::move(sharp));
    normals_ = List<Pair<vector>>(std::move(both));

    if (edges_.size())
    {
        const treeDataEdge items
        (
            false, edges_, surface.points, identity(edges_.size())
        );
        const boundBox box(surface.points, false);
        tree_ = makeSearchTree(items, box, 0.01, 10);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

pointIndexHit sharpLines::findNearest
(
    const point& x,
    const scalar distance
) const
{
    return tree_.valid()
      ? tree_->findNearest(x, sqr(distance)) : pointIndexHit();
}


bool sharpLines::isBetween
(
    const label edgei,
    const vector& m,
    const vector& n
) const
{
    const vector& a = normals_[edgei].first();
    const vector& b = normals_[edgei].second();

    return max(min(mag(a & m), mag(b & n)), min(mag(a & n), mag(b & m)))
      > alongCosine;
}

} // End namespace Foam

// ************************************************************************* //
