/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatch.H"
#include "boundBox.H"
#include "CompactListList.H"
#include "DynamicList.H"
#include "error.H"
#include "linePointRef.H"
#include "ListOps.H"
#include "ranges.H"
#include "sideShape.H"
#include "stageProgress.H"

#include <algorithm>

namespace Foam
{

static triSurface trianglesOf(const pointField& points, const faceList& faces)
{
    DynamicList<labelledTri> triangles;
    for (const face& f : faces)
    {
        for (label k = 1; k + 1 < f.size(); ++k)
        {
            triangles.append(labelledTri(f[0], f[k], f[k + 1], 0));
        }
    }

    return triSurface(triangles, points);
}


static vectorField outwardNormals(const triSurface& surface)
{
    vectorField normals(surface.size());
    forAll(normals, i)
    {
        normals[i] = -normalised(surface[i].areaNormal(surface.points()));
    }

    return normals;
}


//- At each point the mean, weighted by the angles there
static vectorField atPoints
(
    const triSurface& surface,
    const vectorField& normals
)
{
    vectorField atPoints(surface.points().size(), vector::zero);
    forAll(surface, i)
    {
        const labelledTri& t = surface[i];
        forAll(t, k)
        {
            const point& x = surface.points()[t[k]];
            const vector a = surface.points()[t[t.fcIndex(k)]] - x;
            const vector b = surface.points()[t[t.rcIndex(k)]] - x;
            atPoints[t[k]] += ::atan2(mag(a ^ b), a & b)*normals[i];
        }
    }
    for (vector& n : atPoints)
    {
        n.normalise();
    }

    return atPoints;
}


treeBoundBox searchBox(const pointField& points)
{
    treeBoundBox bounds(points);
    bounds.inflate(1e-3);

    return bounds;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

vector sideShape::normalAt(const label triangle, const point& x) const
{
    const labelledTri& t = surface_[triangle];
    label type, element;
    t.nearestPointClassify(x, surface_.points(), type, element);

    if (type == triPointRef::POINT)
    {
        return pointNormals_[t[element]];
    }

    vector normal(faceNormals_[triangle]);
    if (type == triPointRef::EDGE)
    {
        const edge e(t[element], t[t.fcIndex(element)]);
        const label p = surface_.whichPoint(e[0]);
        for (const label other : surface_.pointFaces()[p])
        {
            if (other != triangle && surface_[other].found(e[1]))
            {
                normal += faceNormals_[other];
            }
        }
    }

    return normalised(normal);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sideShape::sideShape(const pointField& points, const faceList& faces)
:
    surface_(trianglesOf(points, faces)),
    faceNormals_(outwardNormals(surface_)),
    pointNormals_(atPoints(surface_, faceNormals_)),
    tree_(treeDataTriSurface(true, surface_, 0), searchBox(points), 12, 10, 3)
{
    // Made on demand otherwise, which threads must not do
    surface_.pointFaces();
    surface_.meshPointMap();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

sidePlane sideShape::planeAt(const point& x) const
{
    const pointIndexHit hit(nearest(x));

    return sidePlane{hit.rawPoint(), normalAt(hit.index(), x)};
}


point sideShape::along
(
    const point& x,
    const vector& direction,
    const scalar distance
) const
{
    const vector reach(distance*direction);
    const pointIndexHit ahead(tree_.findLine(x, x + reach));
    const pointIndexHit behind(tree_.findLine(x, x - reach));

    if (!ahead.hit() && !behind.hit())
    {
        return nearest(x).rawPoint();
    }

    const bool isAhead =
        ahead.hit()
     && (
            !behind.hit()
         || magSqr(ahead.rawPoint() - x) < magSqr(behind.rawPoint() - x)
        );

    return isAhead ? ahead.rawPoint() : behind.rawPoint();
}


// * * * * * * * * * * * * * * *  Side Curve * * * * * * * * * * * * * * * * //

typedef std::pair<point, point> segment;

static DynamicList<segment> segmentsOf(const sidePatch& part)
{
    DynamicList<segment> segments;
    for (const edge& e : outline(part.faces))
    {
        segments.append(segment(part.points[e.start()], part.points[e.end()]));
    }

    return segments;
}


static DynamicList<segment> commonSegments
(
    const sidePatch& part,
    const sidePatch& other
)
{
    const scalar tolerance = 1e-9*boundBox(part.points, false).mag();
    const DynamicList<segment> others(segmentsOf(other));
    DynamicList<segment> common;
    for (const segment& s : segmentsOf(part))
    {
        if
        (
            other.isPart()
          ? others.found(segment(s.second, s.first))
          : other.hasEdge(s.first, s.second, tolerance)
        )
        {
            common.append(s);
        }
    }

    return common;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

sideCurve::foot sideCurve::footOf(const point& x) const
{
    foot best{points_[0], 0};
    scalar least = magSqr(x - points_[0]);
    scalar length = 0;

    for (label i = 1; i < points_.size(); ++i)
    {
        const linePointRef line(points_[i - 1], points_[i]);
        const point at(line.nearestDist(x).rawPoint());

        if (magSqr(x - at) < least)
        {
            least = magSqr(x - at);
            best = foot{at, length + mag(at - points_[i - 1])};
        }
        length += line.mag();
    }

    return best;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sideCurve::sideCurve
(
    const sidePatch& first,
    const sidePatch& second,
    const point& from
)
{
    DynamicList<segment> segments
    (
        first.isPart()
      ? commonSegments(first, second) : commonSegments(second, first)
    );
    points_.append(from);

    for (label i = 0; i < segments.size(); ++i)
    {
        const point end(points_.last());
        const segment s(segments[i]);

        if (s.first == end || s.second == end)
        {
            points_.append(s.first == end ? s.second : s.first);
            segments.remove(i);
            i = -1;
        }
    }
}


// * * * * * * * * * * * * * * *  Side Patch * * * * * * * * * * * * * * * * //

//- Unit normals of one plane differ by less
static constexpr scalar sameNormal = 1e-4;

//- Bound on the projections, in turn, on side patches some of which are curved
static constexpr label maxPasses = 20;


//- The move of x onto a plane that leaves it on those before, whose directions
//  are orthonormal; the direction of the move is added to them
static point movedOnto
(
    const sidePlane& side,
    const point& x,
    DynamicList<vector>& directions
)
{
    vector e(side.normal);
    for (const vector& d : directions)
    {
        e -= (e & d)*d;
    }

    // The same plane once more
    if (magSqr(e) < 1e-12)
    {
        return x;
    }

    e.normalise();
    directions.append(e);

    return x - side.distance(x)/(side.normal & e)*e;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

sidePlane sidePatch::planeAt(const point& x) const
{
    return shape ? shape->planeAt(x) : sidePlane(*this);
}


scalarField distancesTo(const sidePatch& side, const pointField& points)
{
    scalarField distances(points.size());
    forAll(distances, p)
    {
        distances[p] = side.distance(points[p]);
    }

    return distances;
}


bool isSamePlane
(
    const sidePlane& a,
    const sidePlane& b,
    const scalar tolerance
)
{
    return mag(a.distance(b.origin)) <= tolerance
        && mag(b.normal - a.normal) < sameNormal;
}


labelList wallBorder::pointsOn(const label side) const
{
    DynamicList<label> points;
    forAll(edges, i)
    {
        if (edgeSides[i] == side)
        {
            points.append(edges[i]);
        }
    }
    labelList sorted(std::move(points));
    inplaceUniqueSort(sorted);

    return sorted;
}


Map<labelPair> wallBorder::pointSides() const
{
    Map<labelPair> sides(2*edges.size());

    forAll(edges, i)
    {
        sides(edges[i].start(), labelPair(-1, -1)).first() = edgeSides[i];
        sides(edges[i].end(), labelPair(-1, -1)).second() = edgeSides[i];
    }

    return sides;
}


void checkSides
(
    const UList<sidePatch>& sides,
    const UList<word>& wallPatchNames
)
{
    for (const sidePatch& side : sides)
    {
        if (wallPatchNames.found(side.name))
        {
            FatalErrorInFunction
                << "The side patch " << side.name << " has the name of a patch"
                << " of the wall" << nl << "Rename the side, or the patch by"
                << " surface.patches" << exit(FatalError);
        }

        if
        (
            side.isCurved()
         && (side.type == "symmetryPlane" || side.type == "empty")
        )
        {
            FatalErrorInFunction
                << "The side patch " << side.name << " of type " << side.type
                << " is curved near " << side.origin << nl
                << "Give it the type patch, wall or symmetry"
                << exit(FatalError);
        }

        for (const sidePatch& other : sides)
        {
            if (other.name == side.name && other.type != side.type)
            {
                FatalErrorInFunction
                    << "Two side patches have the name " << side.name
                    << " and the types " << side.type << " and " << other.type
                    << nl << "Rename one of them" << exit(FatalError);
            }

            if
            (
                other.name == side.name && side.type == "symmetryPlane"
             && (side.normal & other.normal) < 1 - 1e-6
            )
            {
                FatalErrorInFunction
                    << "The side patch " << side.name << " of type"
                    << " symmetryPlane is in several planes, at "
                    << side.origin << " and at " << other.origin << nl
                    << "Give it the type symmetry" << exit(FatalError);
            }
        }
    }
}


wordList sidePatchNames(const wallBorder& border)
{
    DynamicList<word> names;
    for (const sidePatch& side : border.sides)
    {
        if (!names.found(side.name))
        {
            names.append(side.name);
        }
    }

    return wordList(std::move(names));
}


bool hasPlanes(const UList<sidePatch>& sides)
{
    return anyOf(sides, [](const sidePatch& side) { return !side.isPart(); });
}


//- The upper ends of the edges of all faces, by their lower ends
static CompactListList<label> upperEnds(const faceList& faces)
{
    label last = -1;
    for (const face& f : faces)
    {
        last = max(last, max(f));
    }

    labelList nEdges(last + 1, Zero);
    const auto visit = [&](const auto& visitEdge)
    {
        for (const face& f : faces)
        {
            forAll(f, k)
            {
                const edge e(f.faceEdge(k));
                visitEdge(e.minVertex(), e.maxVertex());
            }
        }
    };
    visit([&](const label low, const label) { ++nEdges[low]; });

    CompactListList<label> ends(nEdges);
    labelList next(SubList<label>(ends.offsets(), nEdges.size()));
    visit([&](const label low, const label high)
    {
        ends.m()[next[low]++] = high;
    });

    return ends;
}


edgeList outline(const faceList& faces)
{
    const CompactListList<label> ends(upperEnds(faces));
    const auto isOpen = [&](const edge& e)
    {
        const UList<label> all(ends[e.minVertex()]);

        return std::count(all.begin(), all.end(), e.maxVertex()) == 1;
    };

    boolList onBorder(faces.size());
    #pragma omp parallel for schedule(static, 256)
    forAll(faces, i)
    {
        const face& f = faces[i];
        bool any = false;
        for (label k = 0; k < f.size() && !any; ++k)
        {
            any = isOpen(f.faceEdge(k));
        }
        onBorder[i] = any;
    }

    DynamicList<edge> edges;
    for (const label i : findIndices(onBorder, true))
    {
        const face& f = faces[i];
        forAll(f, k)
        {
            if (isOpen(f.faceEdge(k)))
            {
                edges.append(f.faceEdge(k));
            }
        }
    }

    return edgeList(std::move(edges));
}


point onAll(const UList<sidePatch>& sides, const labelUList& some, point x)
{
    // In planes the second pass takes away the rounding of the first
    const bool isCurved =
        anyOf(some, [&](const label s) { return sides[s].isCurved(); });

    const auto move = [&]()
    {
        const point before(x);
        DynamicList<vector> directions;

        for (const label s : some)
        {
            x = sides[s].isCurved()
              ? sides[s].shape->nearest(x).rawPoint()
              : movedOnto(sides[s], x, directions);
        }

        return x != before;
    };

    if (isCurved)
    {
        repeatUntilStable("moving onto curved sides", maxPasses, move);
    }
    else if (move())
    {
        move();
    }

    return x;
}

} // End namespace Foam

// ************************************************************************* //
