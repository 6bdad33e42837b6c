/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "givenSurface.H"
#include "linePointRef.H"
#include "stageProgress.H"
#include "triPointRef.H"
#include "unitConversion.H"

namespace Foam
{

//- Faces narrower than this share of the deviation have no normal
static constexpr scalar sliverWidth = 0.1;

//- The normals of slivers are those of neighbours, found in so many steps
static constexpr label maxSteps = 20;


static scalar height(const face& f, const label k, const pointField& points)
{
    return 2*f.mag(points)/max(f.faceEdge(k).mag(points), VSMALL);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void givenSurface::setNormals(const wallSides& sides)
{
    const faceList& faces = surface_.faces;
    const pointField& points = surface_.points;
    labelList across(faces.size(), -1);
    boolList hasNormal(faces.size(), true);
    normals_ = surface_.faceNormals();

    forAll(faces, facei)
    {
        const label k = faces[facei].longestEdge(points);
        hasNormal[facei] =
            height(faces[facei], k, points) > sliverWidth*deviations_[facei];
    }

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> both(sides.on(e));
        if (both.size() != 2)
        {
            continue;
        }
        for (label i = 0; i < 2; ++i)
        {
            const wallSide& side = both[i];
            const face& f = faces[side.facei];
            if (f.faceEdge(f.longestEdge(points)) == edge(side.low, side.high))
            {
                across[side.facei] = both[1 - i].facei;
            }
        }
    }

    forAll(faces, facei)
    {
        label other = facei;
        repeatUntilStable("looking for a normal", maxSteps, [&]()
        {
            if (hasNormal[other])
            {
                normals_[facei] = normals_[other];
                return false;
            }
            other = across[other];

            return other >= 0;
        });
    }
}


label givenSurface::walk
(
    const label start,
    const point& x,
    const scalar reach,
    point& nearest
) const
{
    const pointField& points = surface_.points;
    label best = start;
    scalar least = GREAT;
    found_.clear();
    ++search_;

    // Faces to look at, whose common edge with one before is as near as any
    DynamicList<label, 16> front(1, start);
    seen_[start] = search_;

    while (front.size())
    {
        const label facei = front.remove();
        found_.append(facei);
        const face& f = surface_.faces[facei];
        const triPointRef triangle(points[f[0]], points[f[1]], points[f[2]]);
        const point y(triangle.nearestPoint(x).rawPoint());
        const scalar distance = magSqr(x - y);

        if (distance < least)
        {
            least = distance;
            best = facei;
            nearest = y;
        }
        if (distance > max(least*(1 + 1e-9), sqr(reach)))
        {
            continue;
        }

        for (label k = 0; k < 3; ++k)
        {
            const label other = neighbours_[facei][k];
            if (other < 0 || seen_[other] == search_) continue;

            // Is the edge within reach, or is y on it?
            const linePointRef side(points[f[k]], points[f.nextLabel(k)]);
            const point z(side.nearestDist(x).rawPoint());
            const scalar rounding = 1e-12*magSqr(side.vec());

            if (magSqr(x - z) <= sqr(reach) || magSqr(y - z) <= rounding)
            {
                seen_[other] = search_;
                front.append(other);
            }
        }
    }

    return best;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

givenSurface::givenSurface
(
    const wallSurface& surface,
    const scalar featureAngle,
    const scalar deviation,
    const scalar maxEdge
)
:
    surface_(surface),
    deviations_(surface.faces.size(), deviation),
    seen_(surface.faces.size(), Zero)
{
    const wallSides sides(makeWallSides(surface));
    const scalar minCos = Foam::cos(degToRad(featureAngle));
    setNormals(sides);
    setLines(sides, minCos, maxEdge);
    setCorners(minCos);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label givenSurface::findFace
(
    const label start,
    const point& x,
    const scalar reach,
    point& nearest
) const
{
    const label near = walk(start, x, 0, nearest);

    return
        magSqr(x - nearest) <= sqr(deviations_[near])
      ? near
      : walk(start, x, reach, nearest);
}


labelList givenSurface::around
(
    const label start,
    const point& x,
    const scalar reach
) const
{
    point y;
    walk(start, x, reach, y);

    return found_;
}


label givenSurface::findLine
(
    const label start,
    const point& x,
    point& nearest
) const
{
    label best = start;
    scalar least = GREAT;
    label previous = -1;
    label line = start;

    while (line >= 0)
    {
        const point& a = surface_.points[lines_[line].start()];
        const point& b = surface_.points[lines_[line].end()];
        const scalar t = ((x - a) & (b - a))/max(magSqr(b - a), VSMALL);
        const point y(a + min(max(t, scalar(0)), scalar(1))*(b - a));

        if (magSqr(x - y) >= least && line != start)
        {
            break;
        }
        least = magSqr(x - y);
        best = line;
        nearest = y;

        const label next =
            t <= 0 ? nextLines_[line].first()
          : t >= 1 ? nextLines_[line].second()
          : -1;
        if (next == previous)
        {
            break;
        }
        previous = line;
        line = next;
    }

    return best;
}


scalarField givenSurface::lengths() const
{
    const pointField& points = surface_.points;
    scalarField result(surface_.faces.size(), GREAT);
    forAll(result, facei)
    {
        for (label k = 0; k < 3; ++k)
        {
            const label other = neighbours_[facei][k];
            if (other < 0)
            {
                continue;
            }

            const face& f = surface_.faces[facei];
            const face& g = surface_.faces[other];
            const edge e(f.faceEdge(k));
            const scalar width =
                (
                    height(f, k, points) + height(g, g.edges().find(e), points)
                )/2;
            const scalar cos = normals_[facei] & normals_[other];
            const scalar turn =
                Foam::acos(min(max(cos, scalar(-1)), scalar(1)));
            const scalar radius = width/max(turn, SMALL);

            result[facei] = min
            (
                result[facei],
                min(Foam::sqrt(6*deviations_[facei]*radius), radius)
            );
        }
    }

    return result;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool givenSurface::isCrease
(
    const wallSide& a,
    const wallSide& b,
    const scalar maxEdge
) const
{
    if (maxEdge == 0)
    {
        return false;
    }

    const edge both(a.low, a.high);
    scalar width = GREAT;
    for (const label facei : {a.facei, b.facei})
    {
        const face& f = surface_.faces[facei];
        width = min(width, height(f, f.edges().find(both), surface_.points));
    }

    // The middle of an edge whose ends are equally far from the crease
    const scalar cosine = normals_[a.facei] & normals_[b.facei];
    const scalar sineOfHalf = Foam::sqrt(max(0.5*(1 - cosine), scalar(0)));

    const scalar deviation = min(deviations_[a.facei], deviations_[b.facei]);

    return width > maxEdge && 0.5*maxEdge*sineOfHalf > deviation;
}


void givenSurface::setLines
(
    const wallSides& sides,
    const scalar minCos,
    const scalar maxEdge
)
{
    const faceList& faces = surface_.faces;
    FixedList<label, 3> none(-1);
    neighbours_ = List<FixedList<label, 3>>(faces.size(), none);
    DynamicList<edge> lines;
    DynamicList<scalar> cosines;
    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> all(sides.on(e));
        const wallSide& a = all[0];
        const edge both(a.low, a.high);

        if (all.size() != 2)
        {
            lines.append(both);
            cosines.append(1);
            continue;
        }

        const wallSide& b = all[1];
        const scalar cosine = normals_[a.facei] & normals_[b.facei];
        if
        (
            surface_.patchIDs[a.facei] != surface_.patchIDs[b.facei]
         || faces[a.facei].size() != 3 || faces[b.facei].size() != 3
         || cosine < minCos || isCrease(a, b, maxEdge)
        )
        {
            lines.append(both);
            cosines.append(min(cosine, scalar(1)));
            continue;
        }
        neighbours_[a.facei][faces[a.facei].edges().find(both)] = b.facei;
        neighbours_[b.facei][faces[b.facei].edges().find(both)] = a.facei;
    }

    lines_ = std::move(lines);
    lineCosines_ = scalarField(std::move(cosines));
}


void givenSurface::setCorners(const scalar minCos)
{
    const label nPoints = surface_.points.size();
    List<labelPair> linesOf(nPoints, labelPair(-1, -1));
    isOnLine_ = boolList(nPoints, false);
    isCorner_ = boolList(nPoints, false);

    forAll(lines_, l)
    {
        for (label k = 0; k < 2; ++k)
        {
            const label p = lines_[l][k];
            labelPair& two = linesOf[p];
            isOnLine_[p] = true;
            isCorner_[p] = isCorner_[p] || two.second() >= 0;
            (two.first() < 0 ? two.first() : two.second()) = l;
        }
    }

    nextLines_ = List<labelPair>(lines_.size(), labelPair(-1, -1));
    forAll(linesOf, p)
    {
        const labelPair& two = linesOf[p];
        if (!isOnLine_[p] || isCorner_[p])
        {
            continue;
        }
        isCorner_[p] = two.second() < 0;
        if (isCorner_[p])
        {
            continue;
        }

        const point& x = surface_.points[p];
        const edge& before = lines_[two.first()];
        const edge& after = lines_[two.second()];
        const vector in(x - surface_.points[before.otherVertex(p)]);
        const vector out(surface_.points[after.otherVertex(p)] - x);
        isCorner_[p] = (in & out) < minCos*mag(in)*mag(out);
        if (!isCorner_[p])
        {
            const label i = (before.start() == p ? 0 : 1);
            const label j = (after.start() == p ? 0 : 1);
            nextLines_[two.first()][i] = two.second();
            nextLines_[two.second()][j] = two.first();
        }
    }
}


// * * * * * * * * * * * * * * *  Near Given * * * * * * * * * * * * * * * * //

//- Largest angle [degrees] between a triangle and the given surface
static constexpr scalar normalAngle = 45;

//- The surface is not further away than this share of the longest edge of a
//  triangle
static constexpr scalar farFromTriangle = 0.1;


scalar reachOf(const FixedList<point, 3>& x)
{
    return max(mag(x[1] - x[0]), max(mag(x[2] - x[1]), mag(x[0] - x[2])));
}


bool isNear
(
    const givenSurface& given,
    const FixedList<point, 3>& triangle,
    label& nearest
)
{
    static const scalar minCos = Foam::cos(degToRad(normalAngle));
    const triPointRef t(triangle[0], triangle[1], triangle[2]);
    const point centre(t.centre());
    const vector area(t.areaNormal());
    const scalar reach = reachOf(triangle);
    point y;
    nearest = given.findFace(nearest, centre, reach, y);

    return
        mag(centre - y) <= min(given.deviation(nearest), farFromTriangle*reach)
     && (area & given.normals()[nearest]) > minCos*mag(area);
}


bool isNear
(
    const givenSurface& given,
    const point& a,
    const point& b,
    const label start
)
{
    const point x(0.5*(a + b));
    point y;
    const scalar reach = mag(a - b);
    const label near = given.findFace(start, x, reach, y);

    return mag(x - y) <= min(given.deviation(near), farFromTriangle*reach);
}

} // End namespace Foam

// ************************************************************************* //
