/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSearch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static vectorField unitNormals(const triSurface& surface)
{
    vectorField normals(surface.size());

    forAll(normals, i)
    {
        normals[i] = normalised(surface[i].areaNormal(surface.points()));
    }

    return normals;
}


namespace
{

//- For indexedOctree: skips the triangles that do not oppose a direction. Of
//  equally near triangles it takes the first one, whatever the tree is: a
//  search on a part of a wall finds what a search on the wall does.
struct oppositeOnly
{
    const triSurface& surface;
    const vectorField& normals;
    const vector& direction;
    const scalar cosine;

    scalar& leastDistSqr;
    label& index;

    //- Boxes of the tree at the least distance are looked at in spite of
    //  rounding
    static constexpr scalar margin = 1 + 1e-9;

    void operator()
    (
        const labelUList& indices,
        const point& sample,
        scalar& nearestDistSqr,
        label& minIndex,
        point& nearestPoint
    ) const
    {
        for (const label i : indices)
        {
            if ((normals[i] & direction) > cosine)
            {
                continue;
            }

            const pointHit hit
            (
                surface[i].nearestPoint(sample, surface.points())
            );

            const scalar distSqr = sqr(hit.distance());
            const bool isFirst = distSqr == leastDistSqr && i < index;

            if (distSqr < leastDistSqr || isFirst)
            {
                leastDistSqr = distSqr;
                nearestDistSqr = min(nearestDistSqr, margin*distSqr);
                index = minIndex = i;
                nearestPoint = hit.rawPoint();
            }
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

wallSearch::wallSearch(const wallSurface& wall)
:
    surface_(toTriSurface(wall)),
    normals_(unitNormals(surface_)),
    tree_
    (
        treeDataTriSurface(true, surface_, 0),
        searchBox(wall.points),
        12,
        10,
        3
    ),
    sides_(wall.border.sides)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool wallSearch::nearer(const point& x, const scalar distance) const
{
    return tree_.findNearest(x, sqr(distance)).hit();
}


wallSearch::foot wallSearch::footOf(const point& x) const
{
    const pointIndexHit hit(tree_.findNearest(x, GREAT));
    const labelledTri& tri = surface_[hit.index()];
    const barycentric2D weights
    (
        tri.tri(surface_.points()).pointToBarycentric(hit.rawPoint())
    );

    foot result;
    forAll(tri, k)
    {
        result.points[k] = tri[k];
        result.weights[k] = min(max(weights[k], scalar(0)), scalar(1));
    }
    result.distance = mag(x - hit.rawPoint());
    result.direction = normalised(x - hit.rawPoint());

    return result;
}


scalar wallSearch::longestEdgeAt(const point& x) const
{
    const triPointRef tri
    (
        surface_[tree_.findNearest(x, GREAT).index()].tri(surface_.points())
    );

    return max
    (
        mag(tri.b() - tri.a()),
        max(mag(tri.c() - tri.b()), mag(tri.a() - tri.c()))
    );
}


pointIndexHit wallSearch::nearestInTree
(
    const point& x,
    const scalar distance,
    const vector& direction,
    const scalar cosine
) const
{
    scalar leastDistSqr = sqr(distance);
    label index = -1;

    return tree_.findNearest
    (
        x,
        leastDistSqr,
        oppositeOnly
        {
            surface_, normals_, direction, cosine, leastDistSqr, index
        }
    );
}


pointIndexHit wallSearch::nearestOpposite
(
    const point& x,
    const scalar distance,
    const vector& direction,
    const scalar cosine
) const
{
    pointIndexHit nearest(nearestInTree(x, distance, direction, cosine));

    // Labels of the triangles of images follow
    for (label s = 0; s < sides_.size(); ++s)
    {
        const scalar least =
            nearest.hit() ? mag(x - nearest.rawPoint()) : distance;

        if (sides_.isNear(s, x, least))
        {
            const sidePlane side(sides_[s].planeAt(x));
            const pointIndexHit hit
            (
                nearestInTree
                (
                    side.reflectedPoint(x), least, side.reflected(direction),
                    cosine
                )
            );

            if (hit.hit())
            {
                nearest = pointIndexHit
                (
                    true, side.reflectedPoint(hit.rawPoint()),
                    hit.index() + (s + 1)*surface_.size()
                );
            }
        }
    }

    return nearest;
}


void wallSearch::prepareInFront() const
{
    surface_.localFaces();
    surface_.localPoints();
    surface_.edgeFaces();
    surface_.faceEdges();
    surface_.pointEdges();
    surface_.faceNormals();
    tree_.getVolumeType(tree_.bb().midpoint());
}


bool wallSearch::overlaps(const boundBox& box) const
{
    // The nearest point answers for most boxes; all triangles in a box are many
    const point centre(box.midpoint());
    const pointIndexHit nearest
    (
        tree_.findNearest(centre, 0.25*magSqr(box.span()))
    );

    return nearest.hit()
     && (
            box.contains(nearest.hitPoint())
         || tree_.findBox(treeBoundBox(box)).size()
        );
}


scalar wallSearch::opposition
(
    const label triangle,
    const point& x,
    const vector& direction
) const
{
    const label image = triangle/surface_.size();
    const vector seen
    (
        image ? sides_[image - 1].planeAt(x).reflected(direction) : direction
    );
    const scalar from = clearanceControls::oppositeFrom;
    const scalar share =
        (from - (normals_[triangle % surface_.size()] & seen))
       /(from - clearanceControls::oppositeFully);

    return min(max(share, scalar(0)), scalar(1));
}

} // End namespace Foam

// ************************************************************************* //
