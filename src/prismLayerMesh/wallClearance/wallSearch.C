/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSearch.H"
#include "mathematicalConstants.H"
#include "searchTree.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sideSearch::sideSearch(const List<sidePatch>& sides)
:
    sides_(sides),
    parts_(sides.size())
{
    forAll(sides_, s)
    {
        const sidePatch& side = sides_[s];

        if (side.isPart())
        {
            parts_[s] = side.isCurved()
              ? side.shape
              : std::make_shared<const sideShape>(side.points, side.faces);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool sideSearch::isNear
(
    const label side,
    const point& x,
    const scalar distance
) const
{
    return mag(sides_[side].distance(x)) < distance
     && (!parts_[side] || parts_[side]->nearest(x, distance).hit());
}


bool sideSearch::putOnSides
(
    const point& from,
    const scalar distance,
    point& x,
    labelPair& sides
) const
{
    sides = labelPair(-1, -1);
    DynamicList<label> near;
    forAll(sides_, s)
    {
        const sidePatch& side = sides_[s];

        if (near.size() < 2 && isNear(s, x, distance))
        {
            sides[near.size()] = s;
            near.append(s);
        }
        else if
        (
            side.distance(x) > 0
         && (!parts_[s] || parts_[s]->hit(from, x).hit())
        )
        {
            return false;
        }
    }

    x = onAll(sides_, near, x);

    return true;
}


// * * * * * * * * * * * * * * *  Triangle Tree  * * * * * * * * * * * * * * //

//- Most triangles of a leaf
static const label leafSize = 6;

//- Boxes, and cones of normals, that miss by rounding alone are looked at
static const scalar distanceMargin = 1 - 1e-9;
static const scalar productMargin = 1e-9;


static scalar angleBetween(const vector& a, const vector& b)
{
    // Exact to rounding also for small angles, as acos is not
    return ::atan2(mag(a ^ b), a & b);
}


// * * * * * * * * * * * * * * * * Nested Types  * * * * * * * * * * * * * * //

void triangleTree::node::add(const point& x)
{
    min = Foam::min(min, x);
    max = Foam::max(max, x);
}


void triangleTree::node::setAngle(const scalar halfAngle)
{
    angle = Foam::min(halfAngle, constant::mathematical::pi);
    cosine = ::cos(angle);
    sine = ::sin(angle);
}


scalar triangleTree::node::distanceSqr(const point& x) const
{
    return magSqr(x - Foam::min(Foam::max(x, min), max));
}


scalar triangleTree::node::leastProduct(const vector& direction) const
{
    // cos(a + b) of the angle a of the direction and the half angle b
    const scalar c = axis & direction;

    return c <= -cosine
      ? -1 : c*cosine - ::sqrt(Foam::max(1 - sqr(c), scalar(0)))*sine;
}


struct triangleTree::query
{
    const point& x;
    const vector& direction;
    const scalar cosine;

    scalar leastSqr;
    label index = -1;
    point at = Zero;


    //- Whether a node may have what is looked for
    bool mayHave(const node& n, const scalar distanceSqr) const
    {
        return distanceMargin*distanceSqr <= leastSqr
            && n.leastProduct(direction) - productMargin <= cosine;
    }
};


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

labelRange triangleTree::trianglesOf(const label leaf) const
{
    const std::int64_t n = surface_.size();
    const label first = leaf*n/nLeaves_;

    return labelRange(first, label((leaf + 1)*n/nLeaves_) - first);
}


triangleTree::node triangleTree::makeLeaf(const label leaf) const
{
    node result;
    for (const label i : trianglesOf(leaf))
    {
        result.axis += normals_[i];
        for (const label p : surface_[i])
        {
            result.add(surface_.points()[p]);
        }
    }
    result.axis = normalised(result.axis);

    scalar angle = 0;
    for (const label i : trianglesOf(leaf))
    {
        angle = max(angle, angleBetween(result.axis, normals_[i]));
        if (mag(result.axis) < 0.5 || mag(normals_[i]) < 0.5)
        {
            angle = constant::mathematical::pi;
        }
    }
    result.setAngle(angle);

    return result;
}


triangleTree::node triangleTree::join(const node& a, const node& b) const
{
    node result(a);
    result.add(b.min);
    result.add(b.max);
    result.axis = normalised(a.axis + b.axis);
    result.setAngle
    (
        mag(result.axis) < 0.5
      ? constant::mathematical::pi
      : max
        (
            a.angle + angleBetween(result.axis, a.axis),
            b.angle + angleBetween(result.axis, b.axis)
        )
    );

    return result;
}


void triangleTree::look(const label leaf, query& q) const
{
    for (const label i : trianglesOf(leaf))
    {
        if ((normals_[i] & q.direction) > q.cosine)
        {
            continue;
        }

        const pointHit hit(surface_[i].nearestPoint(q.x, surface_.points()));
        const scalar distSqr = sqr(hit.distance());
        const bool isFirst = distSqr == q.leastSqr && i < q.index;

        if (distSqr < q.leastSqr || isFirst)
        {
            q.leastSqr = distSqr;
            q.index = i;
            q.at = hit.rawPoint();
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

triangleTree::triangleTree(const triSurface& surface)
:
    surface_(surface),
    normals_(surface.size())
{
    while (nLeaves_*leafSize < surface.size())
    {
        nLeaves_ *= 2;
    }
    nodes_.setSize(2*nLeaves_);

    #pragma omp parallel for schedule(static, 1024)
    forAll(normals_, i)
    {
        normals_[i] = normalised(surface[i].areaNormal(surface.points()));
    }

    #pragma omp parallel for schedule(static, 1024)
    for (label leaf = 0; leaf < nLeaves_; ++leaf)
    {
        nodes_[nLeaves_ + leaf] = makeLeaf(leaf);
    }
    for (label first = nLeaves_/2; first > 0; first /= 2)
    {
        #pragma omp parallel for schedule(static, 1024)
        for (label i = first; i < 2*first; ++i)
        {
            nodes_[i] = join(nodes_[2*i], nodes_[2*i + 1]);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

pointIndexHit triangleTree::nearest
(
    const point& x,
    const scalar distance,
    const vector& direction,
    const scalar cosine
) const
{
    struct entry
    {
        label node;
        scalar distanceSqr;
    };

    // One more for each level at most
    FixedList<entry, 64> waiting;
    label nWaiting = 0;
    query q{x, direction, cosine, sqr(distance)};
    waiting[nWaiting++] = entry{1, nodes_[1].distanceSqr(x)};

    while (nWaiting > 0)
    {
        const entry e = waiting[--nWaiting];
        if (!q.mayHave(nodes_[e.node], e.distanceSqr))
        {
            continue;
        }
        if (e.node >= nLeaves_)
        {
            look(e.node - nLeaves_, q);
            continue;
        }

        // The nearer one is looked at first
        const entry a{2*e.node, nodes_[2*e.node].distanceSqr(x)};
        const entry b{2*e.node + 1, nodes_[2*e.node + 1].distanceSqr(x)};
        const bool isFirst = a.distanceSqr <= b.distanceSqr;
        waiting[nWaiting++] = isFirst ? b : a;
        waiting[nWaiting++] = isFirst ? a : b;
    }

    return pointIndexHit(q.index >= 0, q.at, q.index);
}


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
        surface_[nearest_.nearest(x, ROOTVGREAT).index()].tri(surface_.points())
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
    pointIndexHit nearest(nearest_.nearest(x, distance, direction, cosine));

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
    const pointIndexHit nearest(nearest_.nearest(centre, 0.5*mag(box.span())));

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
