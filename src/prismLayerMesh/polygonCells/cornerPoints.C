/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cornerPoints.H"

#include "layerGeometry.H"
#include "UIndirectList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The mean of points. A coordinate that is the same in all points stays it,
//  whatever rounding.
template<class Points, class Weights>
static point meanOf(const Points& points, const Weights& weights)
{
    vector sum(Zero);
    for (label k = 1; k < label(points.size()); ++k)
    {
        sum += weights[k]*(points[k] - points[0]);
    }

    return points[0] + sum;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

FixedList<point, 3> cornerPoints::commonPlaces
(
    const label facei,
    labelList& positions
) const
{
    const face f(rootsOf(layers_, facei));
    FixedList<point, 3> places;
    forAll(f, k)
    {
        const label rank = common_.rank(f, k);
        positions[rank] = k;
        places[rank] = layers_(f[k], 0);
    }

    return places;
}


scalarList cornerPoints::firstWeights(const label facei) const
{
    if (!common_.isCommon.test(facei))
    {
        return innerWeights(layers_, facei, leastShare_);
    }
    labelList positions(3);
    const FixedList<scalar, 3> inner
    (
        innerWeights(commonPlaces(facei, positions), leastShare_)
    );
    scalarList weights(3);
    forAll(positions, k)
    {
        weights[positions[k]] = inner[k];
    }

    return weights;
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
    const numberedEdges onWall(ends);

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
    farEdges_[tets_.edges().find(a, b)] = ofFace(facei, layers_.nLayers);
    const face& f = layers_.faces[facei];
    if (f.size() == 4)
    {
        SubList<scalar> weights(places_.weights, f.size(), starts_[facei]);
        forAll(f, k)
        {
            weights[k] = f[k] == a || f[k] == b ? 0.5 : 0;
        }
    }
}


void cornerPoints::setFarEdges()
{
    farEdges_ = identity(tets_.edges().size(), firstFarEdge());
    for (label e = 0; e < edges_.size(); ++e)
    {
        const label onFar =
            tets_.edges().find(edges_[e].first, edges_[e].second);
        if (onFar >= 0)
        {
            farEdges_[onFar] = ofEdge(e, layers_.nLayers);
        }
    }
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


endsOfEdge cornerPoints::orderedEnds(const label i) const
{
    const endsOfEdge& e = edges_[i];
    const labelList& points = common_.points;
    const bool isTurned =
        points.size()
     && points[layers_.root(e.first)] > points[layers_.root(e.second)];

    return isTurned ? endsOfEdge(e.second, e.first) : e;
}


point cornerPoints::positionOnCommon(const label facei) const
{
    labelList positions(3);
    const FixedList<point, 3> places(commonPlaces(facei, positions));
    const SubList<scalar> weights(places_.weights, 3, starts_[facei]);

    return meanOf(places, UIndirectList<scalar>(weights, positions));
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
        const endsOfEdge e(orderedEnds(i - nColumns));
        const point& a = layers_(e.first, k);

        return a + 0.5*(layers_(e.second, k) - a);
    }
    const label facei = i - nColumns - edges_.size();
    if (k == 0 && common_.isCommon.test(facei))
    {
        return positionOnCommon(facei);
    }

    return inFace(facei, k);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

cornerPoints::cornerPoints
(
    const prismLayers& layers,
    const farFieldMesh& far,
    const farTets& tets,
    const commonTriangles& common,
    const cornerPointControls& controls
)
:
    layers_(layers),
    far_(far),
    tets_(tets),
    common_(common),
    leastShare_(controls.leastShare),
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
    edges_ = numberedEdges(ends);
    places_.weights.setSize(starts_.last());
    forAll(layers.faces, facei)
    {
        setWeights(facei, firstWeights(facei));
    }
    setRoots();
    setFarEdges();
    setBoundary();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label cornerPoints::ofFarPoint(const label p) const
{
    return
        p < layers_.nColumns()
      ? ofColumn(p, layers_.nLayers) : firstFarPoint() + p;
}


label cornerPoints::ofFarEdge(const label a, const label b) const
{
    const label e = tets_.edges().find(a, b);

    return e < 0 ? -1 : farEdges_[e];
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


label cornerPoints::wallFaceOf(const label i) const
{
    const label facei = i % perLevel() - layers_.nColumns() - edges_.size();

    const bool isOnWall =
        i < firstFarPoint() && facei >= 0 && facei < layers_.nWallFaces();

    return isOnWall && !common_.isCommon.test(facei) ? facei : -1;
}


void cornerPoints::setWeights(const label facei, const UList<scalar>& weights)
{
    SubList<scalar>(places_.weights, weights.size(), starts_[facei]) = weights;
}


point cornerPoints::inFace(const label facei, const label level) const
{
    return meanOf
    (
        levelPoints{layers_, layers_.faces[facei], level}, weights(facei)
    );
}


void cornerPoints::fixTet(const label t)
{
    visitInner(t, [&](const label i)
    {
        places_.moved.erase(i);
        places_.fixed.insert(i);
    });
}


bool cornerPoints::isFree(const label i) const
{
    if (places_.fixed.found(i))
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
    if (i < firstFarPoint())
    {
        return positionOnLevel(i % perLevel(), i/perLevel());
    }
    if (i < firstFarEdge())
    {
        return far_.points[i - firstFarPoint()];
    }
    const auto moved = places_.moved.cfind(i);
    if (moved.good())
    {
        return moved.val();
    }
    if (i < firstFarFace())
    {
        const endsOfEdge& e = tets_.edges()[i - firstFarEdge()];
        const point& a = far_.points[e.first];

        return a + 0.5*(far_.points[e.second] - a);
    }
    if (i >= firstFarCell())
    {
        FixedList<point, 4> corners;
        forAll(corners, k)
        {
            corners[k] = far_.points[tets_.points(i - firstFarCell())[k]];
        }

        return meanOf(corners, innerWeights(corners, leastShare_));
    }
    const face& f = far_.topology.faces[i - firstFarFace()];
    if (f.size() != 3)
    {
        return meanOf
        (
            f.points(far_.points), scalarList(f.size(), 1.0/f.size())
        );
    }
    const FixedList<point, 3> corners
    ({
        far_.points[f[0]], far_.points[f[1]], far_.points[f[2]]
    });

    return meanOf(corners, innerWeights(corners, leastShare_));
}

} // End namespace Foam

// ************************************************************************* //
