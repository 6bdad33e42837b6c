/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideRegions.H"
#include "boundBox.H"
#include "DynamicField.H"
#include "farFieldMeshControls.H"
#include "HashSet.H"
#include "linePointRef.H"
#include "MinMax.H"
#include "ranges.H"
#include "sideShape.H"
#include "sparsePoints.H"

namespace Foam
{

//- The curve from a point on two side patches; null if both are plane
static std::shared_ptr<const sideCurve> curveOf
(
    const prismLayers& layers,
    const labelPair& sides,
    const point& root
)
{
    const sidePatch& first = layers.border.sides[sides.first()];
    const sidePatch& second = layers.border.sides[sides.second()];

    return first.isCurved() || second.isCurved()
      ? std::make_shared<const sideCurve>(first, second, root)
      : nullptr;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

scalar layerBorder::shareAt(const corner& c, const point& x) const
{
    const point& end = outerPoints_[c.outerPoint];

    if (c.curve)
    {
        return mag(x - c.curve->nearest(x)) < tolerance_
          ? c.curve->lengthTo(x)/c.curve->lengthTo(end) : -1;
    }

    const vector up(end - c.root);
    const scalar share = ((x - c.root) & up)/magSqr(up);
    const bool onLine = mag(x - c.root - share*up) < tolerance_;

    return onLine && share*mag(up) > -tolerance_
      ? max(share, scalar(0)) : -1;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

layerBorder::layerBorder(const prismLayers& layers, const scalar tolerance)
:
    tolerance_(tolerance)
{
    const Map<labelPair> sidesOf(layers.border.pointSides());
    columns_ = sidesOf.sortedToc();
    outerPoints_.setSize(columns_.size());
    Map<label> outerPointOf;

    forAll(columns_, i)
    {
        const label c = columns_[i];
        const labelPair& sides = sidesOf[c];
        const label rootColumn = layers.root(c);
        const point& root = layers(rootColumn, 0);
        outerPoints_[i] = layers(c, layers.nLayers);
        outerPointOf.insert(c, i);
        roots_.insert(root, rootColumn);

        if (sides.first() != sides.second())
        {
            corners_.append({sides, root, i, curveOf(layers, sides, root)});
        }
    }

    outerEdges_.setSize(layers.border.edges.size());
    forAll(outerEdges_, i)
    {
        const edge& e = layers.border.edges[i];
        wallEdges_.insert
        (
            edge(layers.root(e.start()), layers.root(e.end())), i
        );
        outerEdges_[i] = edge(outerPointOf[e.end()], outerPointOf[e.start()]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool layerBorder::covers(const point& a, const point& b, labelPair& ends) const
{
    ends = labelPair(-1, -1);
    const edge columns(roots_.find(a), roots_.find(b));

    if (columns.start() >= 0 && columns.end() >= 0 && wallEdges_.found(columns))
    {
        return true;
    }

    for (const corner& c : corners_)
    {
        if (outerPoints_[c.outerPoint] == c.root)
        {
            // Without layers the outer point is the point of the outline
            ends.first() = a == c.root ? c.outerPoint : ends.first();
            ends.second() = b == c.root ? c.outerPoint : ends.second();
            continue;
        }
        const scalar shareA = shareAt(c, a);
        const scalar shareB = shareAt(c, b);

        if (shareA >= 0 && shareB >= 0)
        {
            if (shareA < 1 && shareB < 1)
            {
                return true;
            }

            ends.first() = shareA < 1 ? c.outerPoint : ends.first();
            ends.second() = shareB < 1 ? c.outerPoint : ends.second();
        }
    }

    return false;
}


labelList layerBorder::outerPointsOn(const label side) const
{
    DynamicList<label> outerPoints;
    for (const corner& c : corners_)
    {
        if (c.sides.found(side))
        {
            outerPoints.append(c.outerPoint);
        }
    }

    return labelList(std::move(outerPoints));
}


// * * * * * * * * * * * * * * *  Plane Points * * * * * * * * * * * * * * * //

//- The points of the edges of a region
static pointField verticesOf
(
    const pointField& points,
    const planeRegion& region
)
{
    labelHashSet vertices;
    for (const UList<edge>* edges : {&region.boundary, &region.limits})
    {
        for (const edge& e : *edges)
        {
            vertices.insert(e);
        }
    }

    return pointField(points, vertices.sortedToc());
}


namespace
{

class planeSquares
{
    const sidePatch& side_;
    const std::function<scalar(const point&)>& size_;
    vector e1_;
    vector e2_;

    //- The rectangle around the region, along e1 and e2
    scalarMinMax range1_;
    scalarMinMax range2_;

    //- Longer than a side patch is high above its plane
    const scalar reach_;

    DynamicField<point> centres_;
    DynamicField<scalar> sizes_;

    //- The point of the side patch above one of its plane. False if there is
    //  none.
    bool lift(point& x) const
    {
        const sidePlane& plane = side_;
        x -= plane.distance(x)*plane.normal;
        const vector up(reach_*plane.normal);
        const pointIndexHit hit(side_.shape->hit(x - up, x + up));
        x = hit.hit() ? hit.rawPoint() : x;

        return hit.hit();
    }

    point at(const scalar a, const scalar b) const
    {
        return side_.origin + a*e1_ + b*e2_;
    }

    //- Whether the side patch bends away from its tangent plane at x by more
    //  than a share of the width of a square
    bool isBent
    (
        const point& x,
        const scalar a,
        const scalar b,
        const scalar width
    ) const
    {
        const sidePlane tangent(side_.planeAt(x));

        for (const scalar da : {-0.25, 0.25})
        {
            for (const scalar db : {-0.25, 0.25})
            {
                point y(at(a + da*width, b + db*width));

                if
                (
                    lift(y)
                 && mag(tangent.distance(y)) > farFieldTuned.bentShare*width
                )
                {
                    return true;
                }
            }
        }

        return false;
    }

    void divide(const scalar a, const scalar b, const scalar width)
    {
        // The first square may be much longer than the region is wide
        const scalarMinMax along1(a - 0.5*width, a + 0.5*width);
        const scalarMinMax along2(b - 0.5*width, b + 0.5*width);
        if (!range1_.overlaps(along1) || !range2_.overlaps(along2))
        {
            return;
        }

        point x(at(a, b));
        const bool isOn = lift(x);
        const scalar size = size_(x);

        if
        (
            width <= farFieldTuned.squareShare*size
         && (
                !isOn || width < farFieldTuned.leastBentShare*size
             || !isBent(x, a, b, width)
            )
        )
        {
            if (isOn)
            {
                centres_.append(x);
                sizes_.append(min(size, width/farFieldTuned.squareShare));
            }
            return;
        }

        const scalar quarter = width/4;
        divide(a - quarter, b - quarter, width/2);
        divide(a + quarter, b - quarter, width/2);
        divide(a - quarter, b + quarter, width/2);
        divide(a + quarter, b + quarter, width/2);
    }

public:

    planeSquares
    (
        const pointField& vertices,
        const sidePatch& side,
        const std::function<scalar(const point&)>& size
    )
    :
        side_(side),
        size_(size),
        reach_(boundBox(side.points, false).mag())
    {
        // Some direction that is not along the normal
        vector other(Zero);
        other[findMin(cmptMag(side.normal))] = 1;
        e1_ = normalised(other ^ side.normal);
        e2_ = side.normal ^ e1_;

        const vectorField d(vertices - side.origin);
        range1_ = minMax(scalarField(d & e1_));
        range2_ = minMax(scalarField(d & e2_));
        divide
        (
            range1_.centre(), range2_.centre(),
            1.001*max(range1_.mag(), range2_.mag())
        );
    }

    const DynamicField<point>& centres() const { return centres_; }
    const DynamicField<scalar>& sizes() const { return sizes_; }
};

} // End anonymous namespace


//- Returns the centres of squares in the mean plane of a curved side patch,
//  over all that the boundary and limits of a region bound. The centres are
//  moved onto the side patch along the normal of the plane.
//  The squares are divided until they are narrower than 0.85 times the size [m]
//  at their centre, so that their diagonals are not longer than refineSurface
//  allows, and further if the side patch bends in them. A centre is left
//  out if it is nearer than 0.7 times the size to another centre or to a point
//  of the region, or nearer than half of the size to an edge of the limits.
static pointField curvedPoints
(
    const pointField& points,
    const planeRegion& region,
    const sidePatch& side,
    const std::function<scalar(const point&)>& size
)
{
    const pointField vertices(verticesOf(points, region));
    const planeSquares squares(vertices, side, size);

    DynamicField<point> all(vertices);
    DynamicField<scalar> distances;
    for (const point& x : vertices)
    {
        distances.append(farFieldTuned.apartShare*size(x));
    }

    forAll(squares.centres(), i)
    {
        const point& x = squares.centres()[i];
        const bool nearLimit = anyOf(region.limits, [&](const edge& e)
        {
            return e.line(points).nearestDist(x).distance()
                < farFieldTuned.limitShare*squares.sizes()[i];
        });

        if (!nearLimit)
        {
            all.append(x);
            distances.append(farFieldTuned.apartShare*squares.sizes()[i]);
        }
    }

    const labelList kept(sparsePoints(all, distances));
    DynamicField<point> result(kept.size());
    for (const label p : kept)
    {
        if (p >= vertices.size())
        {
            result.append(point(all[p]));
        }
    }

    return pointField(std::move(result));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sideRegions::sideRegions
(
    const prismLayers& layers,
    const std::function<scalar(const point&)>& size,
    const scalar tolerance,
    const wordList& patchNames,
    const wordList& patchTypes
)
:
    sides(layers.border.sides),
    size(size),
    tolerance(tolerance),
    border(layers, tolerance),
    regions(sides.size())
{
    made.surface.patchNames = patchNames;
    made.surface.patchTypes = patchTypes;
    made.firstSide = patchNames.size();
    for (const sidePatch& side : sides)
    {
        made.surface.patchNames.append(side.name);
        made.surface.patchTypes.append(side.type);
    }

    made.columns = border.columns();
    points() = border.outerPoints();
    forAll(border.outerEdges(), i)
    {
        regions[layers.border.edgeSides[i]].boundary.append
        (
            border.outerEdges()[i]
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void sideRegions::triangulate()
{
    forAll(sides, s)
    {
        planeRegion& region = regions[s];
        region.limits = dividedEdges
        (
            points(), region.limits, border.outerPointsOn(s), tolerance
        );
        region.normal = -sides[s].normal;
        region.isCurved = sides[s].isCurved();
        if (region.isCurved)
        {
            const pointField inside
            (
                curvedPoints(points(), region, sides[s], size)
            );
            region.points = identity(inside.size(), points().size());
            points().append(inside);
        }

        // All at once: a list that grows face by face takes quadratic time
        const faceList triangles(triangulatePlane(points(), region));
        made.surface.faces.append(triangles);
        made.surface.patchIDs.append
        (
            labelList(triangles.size(), made.firstSide + s)
        );
    }
}

} // End namespace Foam

// ************************************************************************* //
