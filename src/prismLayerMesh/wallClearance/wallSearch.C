/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSearch.H"
#include "searchTree.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

wallSearch::wallSearch(const wallSurface& wall)
:
    surface_(toTriSurface(wall)),
    nearest_(surface_),
    bounds_(searchBox(wall.points)),
    sides_(wall.border.sides)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool wallSearch::nearer(const point& x, const scalar distance) const
{
    return nearest_.nearest(x, distance).hit();
}


wallSearch::foot wallSearch::footOf(const point& x) const
{
    const pointIndexHit hit(nearest_.nearest(x, ROOTVGREAT));
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
        surface_[nearest_.nearest(x, ROOTVGREAT).index()].tri
        (
            surface_.points()
        )
    );

    return max
    (
        mag(tri.b() - tri.a()),
        max(mag(tri.c() - tri.b()), mag(tri.a() - tri.c()))
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
    pointIndexHit nearest
    (
        nearest_.nearest(x, distance, direction, cosine)
    );

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
                nearest_.nearest
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


const wallSearch::octree& wallSearch::tree() const
{
    std::call_once(prepared_, [this]()
    {
        tree_ = makeSearchTree
        (
            treeDataTriSurface(true, surface_, 0), bounds_, 0, 12
        );

        // What inFront shares between threads
        surface_.localFaces();
        surface_.localPoints();
        surface_.edgeFaces();
        surface_.faceEdges();
        surface_.pointEdges();
        surface_.faceNormals();
        tree_->getVolumeType(tree_->bb().midpoint());
    });

    return *tree_;
}


bool wallSearch::overlaps(const boundBox& box) const
{
    // The nearest point answers for most boxes; all triangles in a box are many
    const point centre(box.midpoint());
    const pointIndexHit nearest
    (
        nearest_.nearest(centre, 0.5*mag(box.span()))
    );

    return nearest.hit()
     && (
            box.contains(nearest.hitPoint())
         || tree().findBox(treeBoundBox(box)).size()
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
        (from - (nearest_.normals()[triangle % surface_.size()] & seen))
       /(from - clearanceControls::oppositeFully);

    return min(max(share, scalar(0)), scalar(1));
}

} // End namespace Foam

// ************************************************************************* //
