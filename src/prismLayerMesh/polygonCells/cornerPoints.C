/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cornerPoints.H"

#include "tensor.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

//- The weights of the circumcentre of a triangle, or zeros if it has no area
static scalarList circumWeights(const point& a, const point& b, const point& c)
{
    const scalar aa = magSqr(c - b), bb = magSqr(a - c), cc = magSqr(b - a);
    scalarList w
    ({
        aa*(bb + cc - aa), bb*(cc + aa - bb), cc*(aa + bb - cc)
    });
    const scalar total = w[0] + w[1] + w[2];
    for (scalar& x : w)
    {
        x = total > VSMALL ? x/total : 0;
    }

    return w;
}


//- The weights of the circumcentre of a tetrahedron, or zeros if it has no
//  volume
static scalarList circumWeights(const UList<point>& p)
{
    const vector u(p[1] - p[0]), v(p[2] - p[0]), w(p[3] - p[0]);
    const scalar det = u & (v ^ w);
    if (mag(det) < VSMALL)
    {
        return scalarList(4, Zero);
    }
    const vector x
    (
        (magSqr(u)*(v ^ w) + magSqr(v)*(w ^ u) + magSqr(w)*(u ^ v))/(2*det)
    );
    scalarList weights(4);
    weights[1] = (x & (v ^ w))/det;
    weights[2] = (x & (w ^ u))/det;
    weights[3] = (x & (u ^ v))/det;
    weights[0] = 1 - weights[1] - weights[2] - weights[3];

    return weights;
}


scalarList innerWeights(const UList<point>& corners, const scalar leastShare)
{
    const label n = corners.size();
    const scalarList w
    (
        n == 3 ? circumWeights(corners[0], corners[1], corners[2])
      : circumWeights(corners)
    );
    scalarList weights(n, 1.0/n);
    if (min(w) == 0 && max(w) == 0)
    {
        return weights;
    }
    scalar way = 1;
    for (const scalar x : w)
    {
        if (n*x < leastShare)
        {
            way = min(way, (1 - leastShare)/(1 - n*x));
        }
    }
    forAll(weights, i)
    {
        weights[i] += way*(w[i] - weights[i]);
    }

    return weights;
}


//- The mean of points. A coordinate that is the same in all points stays it,
//  whatever rounding.
static point meanOf(const UList<point>& points, const UList<scalar>& weights)
{
    vector sum(Zero);
    for (label k = 1; k < points.size(); ++k)
    {
        sum += weights[k]*(points[k] - points[0]);
    }

    return points[0] + sum;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void cornerPoints::setWeights(const label facei, const scalar leastShare)
{
    const face& f = layers_.faces[facei];
    const label n = layers_.nLayers;
    SubList<scalar> weights(weights_, f.size(), starts_[facei]);
    weights = 1.0/f.size();
    if (f.size() != 3)
    {
        return;
    }
    if (facei < layers_.nWallFaces())
    {
        pointField corners(3);
        forAll(corners, k)
        {
            corners[k] = 0.5*(layers_(f[k], 0) + layers_(f[k], n));
        }
        weights = innerWeights(corners, leastShare);
        return;
    }

    // On the wall the point is inside of the edge to which the face shrinks
    forAll(f, k)
    {
        const label root = layers_.root(f[k]);
        const bool isAlone =
            root != layers_.root(f[f.fcIndex(k)])
         && root != layers_.root(f[f.rcIndex(k)]);
        if (isAlone)
        {
            weights = 0.25;
            weights[k] = 0.5;
        }
    }
}


void cornerPoints::setRoots()
{
    const label nColumns = layers_.nColumns();
    std::vector<endsOfEdge> ends;
    for (label e = 0; e < edges_.size(); ++e)
    {
        ends.push_back
        (
            std::minmax
            (
                layers_.root(edges_[e].first), layers_.root(edges_[e].second)
            )
        );
    }
    const numberedEdges onWall{std::vector<endsOfEdge>(ends)};

    roots_ = identity(perLevel());
    for (label c = 0; c < nColumns; ++c)
    {
        roots_[c] = layers_.root(c);
    }
    labelList firstOf(onWall.size(), -1);
    for (label e = 0; e < edges_.size(); ++e)
    {
        label& first = firstOf[onWall.find(ends[e].first, ends[e].second)];
        first = first < 0 ? e : first;
        roots_[nColumns + e] =
            ends[e].first == ends[e].second
          ? ends[e].first : nColumns + first;
    }
    for (label i = layers_.nWallFaces(); i < layers_.faces.size(); ++i)
    {
        const face& f = layers_.faces[i];
        label root = roots_[f[0]];
        forAll(f, k)
        {
            const label e = edges_.find(f[k], f.nextLabel(k));
            root = max(root, roots_[nColumns + e]);
        }
        roots_[nColumns + edges_.size() + i] = root;
    }
}


void cornerPoints::setDiagonal
(
    const label facei,
    const label a,
    const label b
)
{
    diagonals_.insert(tets_.edges().find(a, b), facei);
    const face& f = layers_.faces[facei];
    if (f.size() == 4)
    {
        SubList<scalar> weights(weights_, f.size(), starts_[facei]);
        forAll(f, k)
        {
            weights[k] = f[k] == a || f[k] == b ? 0.5 : 0;
        }
    }
}


void cornerPoints::setDiagonals()
{
    const polyMeshTopology& t = far_.topology;
    forAll(far_.frontFaces, k)
    {
        const face& f = t.faces[t.patchStarts[0] + k];
        forAll(f, i)
        {
            const label a = f[i], b = f.nextLabel(i);
            if (edges_.find(a, b) < 0)
            {
                setDiagonal(far_.frontFaces[k], a, b);
            }
        }
    }
}


void cornerPoints::setBoundary()
{
    const polyMeshTopology& t = far_.topology;
    onBoundary_.resize(far_.points.size());
    const auto set = [&](const label facei)
    {
        onBoundary_.set(t.faces[facei]);
    };
    forAll(t.faces, facei)
    {
        const bool isOuter =
            facei >= t.neighbour.size()
         || t.owner[facei] >= tets_.size()
         || t.neighbour[facei] >= tets_.size();
        if (isOuter)
        {
            set(facei);
        }
    }
}


point cornerPoints::positionOnLevel(const label i, const label k) const
{
    const label nColumns = layers_.nColumns();
    if (i < nColumns)
    {
        return layers_(i, k);
    }
    if (i < nColumns + edges_.size())
    {
        const endsOfEdge& e = edges_[i - nColumns];
        const point& a = layers_(e.first, k);

        return a + 0.5*(layers_(e.second, k) - a);
    }
    const label facei = i - nColumns - edges_.size();
    const face& f = layers_.faces[facei];
    pointField corners(f.size());
    forAll(f, l)
    {
        corners[l] = layers_(f[l], k);
    }

    return meanOf
    (
        corners, SubList<scalar>(weights_, f.size(), starts_[facei])
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

cornerPoints::cornerPoints
(
    const prismLayers& layers,
    const farFieldMesh& far,
    const farTets& tets,
    const cornerPointControls& controls
)
:
    layers_(layers),
    far_(far),
    tets_(tets),
    leastShare_(controls.leastShare),
    centralTets_(tets.size()),
    centralFaces_(far.topology.faces.size()),
    starts_(layers.faces.size() + 1, Zero)
{
    std::vector<endsOfEdge> ends;
    forAll(layers.faces, facei)
    {
        const face& f = layers.faces[facei];
        starts_[facei + 1] = starts_[facei] + f.size();
        forAll(f, k)
        {
            ends.push_back(std::minmax(f[k], f.nextLabel(k)));
        }
    }
    edges_ = numberedEdges(std::move(ends));
    weights_.setSize(starts_.last());
    forAll(layers.faces, facei)
    {
        setWeights(facei, leastShare_);
    }
    setRoots();
    setDiagonals();
    setBoundary();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool cornerPoints::centreFace(const label facei)
{
    const SubList<scalar> weights
    (
        weights_, layers_.faces[facei].size(), starts_[facei]
    );
    const scalarList before(weights);
    if (before.size() == 3)
    {
        setWeights(facei, 1);
    }

    return before != weights;
}


bool cornerPoints::centreTet(const label t)
{
    for (const label facei : tets_.faces(t))
    {
        centralFaces_.set(facei);
    }

    return centralTets_.set(t);
}


label cornerPoints::ofFarPoint(const label p) const
{
    return
        p < layers_.nColumns()
      ? ofColumn(p, layers_.nLayers) : firstFarPoint() + p;
}


label cornerPoints::ofFarEdge(const label a, const label b) const
{
    const label onFront = edges_.find(a, b);
    if (onFront >= 0)
    {
        return ofEdge(onFront, layers_.nLayers);
    }
    const label e = tets_.edges().find(a, b);
    if (e < 0)
    {
        return -1;
    }
    const auto onFace = diagonals_.cfind(e);

    return
        onFace.good()
      ? ofFace(onFace.val(), layers_.nLayers) : firstFarEdge() + e;
}


label cornerPoints::ofFarFace(const label facei) const
{
    const label onLayers = facei - far_.topology.patchStarts[0];
    if (onLayers >= 0 && onLayers < far_.frontFaces.size())
    {
        return ofFace(far_.frontFaces[onLayers], layers_.nLayers);
    }

    return firstFarFace() + facei;
}


bool cornerPoints::isGiven(const label i) const
{
    if (i < firstFarPoint())
    {
        return i % perLevel() < layers_.nColumns();
    }

    return i < firstFarEdge();
}


void cornerPoints::fixTet(const label t)
{
    const FixedList<label, 4>& p = tets_.points(t);
    const auto fix = [&](const label i)
    {
        moved_.erase(i);
        fixed_.insert(i);
    };
    for (label k = 0; k < 4; ++k)
    {
        fix(ofFarFace(tets_.faces(t)[k]));
        for (label l = k + 1; l < 4; ++l)
        {
            fix(ofFarEdge(p[k], p[l]));
        }
    }
}


bool cornerPoints::isFree(const label i) const
{
    if (fixed_.found(i))
    {
        return false;
    }
    if (i >= firstFarCell())
    {
        return true;
    }
    if (i >= firstFarFace())
    {
        const polyMeshTopology& t = far_.topology;
        const label facei = i - firstFarFace();

        return
            facei < t.neighbour.size()
         && t.owner[facei] < tets_.size() && t.neighbour[facei] < tets_.size();
    }
    if (i >= firstFarEdge())
    {
        const endsOfEdge& e = tets_.edges()[i - firstFarEdge()];

        return !onBoundary_.test(e.first) || !onBoundary_.test(e.second);
    }

    return false;
}


point cornerPoints::position(const label i) const
{
    const auto moved = moved_.cfind(i);
    if (moved.good())
    {
        return moved.val();
    }
    if (i < firstFarPoint())
    {
        return positionOnLevel(i % perLevel(), i/perLevel());
    }
    if (i < firstFarEdge())
    {
        return far_.points[i - firstFarPoint()];
    }
    if (i < firstFarFace())
    {
        const endsOfEdge& e = tets_.edges()[i - firstFarEdge()];
        const point& a = far_.points[e.first];

        return a + 0.5*(far_.points[e.second] - a);
    }
    const bool inFace = i < firstFarCell();
    pointField corners(4);
    if (inFace)
    {
        corners = far_.topology.faces[i - firstFarFace()].points(far_.points);
    }
    else
    {
        forAll(corners, k)
        {
            corners[k] = far_.points[tets_.points(i - firstFarCell())[k]];
        }
    }
    const bool isCentral =
        inFace
      ? corners.size() != 3 || centralFaces_.test(i - firstFarFace())
      : centralTets_.test(i - firstFarCell());

    return meanOf
    (
        corners,
        !isCentral
      ? innerWeights(corners, leastShare_)
      : scalarList(corners.size(), 1.0/corners.size())
    );
}

} // End namespace Foam

// ************************************************************************* //
