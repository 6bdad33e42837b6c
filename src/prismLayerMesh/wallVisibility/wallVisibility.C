/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallVisibility.H"
#include "DynamicField.H"
#include "FixedList.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include "ranges.H"
#include "sidePatch.H"
#include "wallChanges.H"

namespace Foam
{

namespace
{

//- Some of the normals, at most three, and the point of their hull that is
//  nearest to the origin
struct supportSet
{
    FixedList<vector, 4> normals;
    label size = 0;
    vector nearest = Zero;
};

} // End anonymous namespace


//- Point nearest to the origin on the line or plane through one to three
//  points; false where it is not inside their hull
static bool nearestInside
(
    const vector& a,
    const vector* b,
    const vector* c,
    vector& nearest
)
{
    if (!b)
    {
        nearest = a;
        return true;
    }

    const vector ab = *b - a;

    if (!c)
    {
        const scalar s = -(a & ab)/max(magSqr(ab), VSMALL);
        nearest = a + s*ab;
        return s > 0 && s < 1;
    }

    const vector ac = *c - a;
    const vector n = ab ^ ac;
    const scalar nn = magSqr(n);

    if (nn < VSMALL)
    {
        return false;
    }

    const scalar s = -((a ^ ac) & n)/nn;
    const scalar t = -((ab ^ a) & n)/nn;
    nearest = a + s*ab + t*ac;

    return s > 0 && t > 0 && s + t < 1;
}


//- Replace the set by its subset of at most three whose hull holds the point
//  of the whole hull nearest to the origin
static supportSet reduced(const supportSet& set)
{
    supportSet best;
    scalar bestSqr = GREAT;

    // A subset contains the normal that came last: without it the nearest
    // point would not have moved
    const vector& last = set.normals[set.size - 1];

    auto consider = [&](const vector* b, const vector* c)
    {
        vector x;
        if (nearestInside(last, b, c, x) && magSqr(x) < bestSqr)
        {
            bestSqr = magSqr(x);
            best.nearest = x;
            best.size = 0;
            if (b) best.normals[best.size++] = *b;
            if (c) best.normals[best.size++] = *c;
            best.normals[best.size++] = last;
        }
    };

    consider(nullptr, nullptr);

    for (label i = 0; i < set.size - 1; ++i)
    {
        consider(&set.normals[i], nullptr);

        for (label j = 0; j < i; ++j)
        {
            consider(&set.normals[i], &set.normals[j]);
        }
    }

    return best;
}


static label lowestAlong(const UList<vector>& normals, const vector& d)
{
    return findMin(scalarField(normals & d));
}


static bool holdsOrigin(const supportSet& set)
{
    if (set.size < 4)
    {
        return false;
    }

    for (label i = 0; i < 4; ++i)
    {
        const vector& a = set.normals[(i + 1) % 4];
        const vector n =
            (set.normals[(i + 2) % 4] - a) ^ (set.normals[(i + 3) % 4] - a);

        // The origin on the same side as the fourth point
        if (((set.normals[i] - a) & n)*(-a & n) <= 0)
        {
            return false;
        }
    }

    return true;
}


visibilityCone makeVisibilityCone(const UList<vector>& normals)
{
    const visibilityCone empty{normalised(sum(normals)), 0};

    supportSet set;
    set.size = 1;
    set.normals[0] = normals[lowestAlong(normals, sum(normals))];
    set.nearest = set.normals[0];

    // Each round lowers |nearest|, so no set comes twice; the bound only
    // guards against rounding
    for (label round = 0; round < 4*normals.size() + 16; ++round)
    {
        const vector& added = normals[lowestAlong(normals, set.nearest)];
        const scalar nearestSqr = magSqr(set.nearest);

        if ((added & set.nearest) >= nearestSqr - visibilityControls::rounding)
        {
            break;
        }

        set.normals[set.size++] = added;

        if (holdsOrigin(set))
        {
            return empty;
        }

        set = reduced(set);

        if (magSqr(set.nearest) >= nearestSqr)
        {
            break;
        }
    }

    const vector axis = normalised(set.nearest);
    const scalar cosine = normals[lowestAlong(normals, axis)] & axis;

    // Below this the sign of d.n_f is not above the rounding of the normals
    if (cosine < 1e-9)
    {
        return empty;
    }

    return visibilityCone{axis, cosine};
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void wallVisibility::setCone(const label p)
{
    vectorField all(cornerNormals[p]);
    all.append(polygonNormals[p]);

    if (sideLines.size() && mag(sideLines[p]) > 0)
    {
        const scalar cosine = min(all & sideLines[p]);
        cones[p] = visibilityCone{sideLines[p], max(cosine, scalar(0))};
    }
    else
    {
        cones[p] = makeVisibilityCone(all);
    }
}


vectorField wallVisibility::axes() const
{
    vectorField axes(cones.size());
    forAll(axes, p)
    {
        axes[p] = cones[p].axis;
    }

    return axes;
}


boolList wallVisibility::narrowCones(const scalar smallestAngle) const
{
    boolList narrow(cones.size());
    forAll(narrow, p)
    {
        narrow[p] = cones[p].empty() || cones[p].cosine < ::sin(smallestAngle);
    }

    return narrow;
}


labelList wallVisibility::emptyCones() const
{
    return subsetList
    (
        identity(cones.size()),
        [&](const label p) { return cones[p].empty(); }
    );
}


vector wallVisibility::limited
(
    const label p,
    const vector& d,
    const scalar margin
) const
{
    const visibilityCone& cone = cones[p];
    const scalar smallest = margin*cone.cosine;

    // No d.n_f can be smaller by more than that
    if (cone.cosine - mag(d - cone.axis) > smallest)
    {
        return d;
    }

    // d + s*(axis - d) is no longer than 1, so what holds for it holds for
    // its unit vector
    scalar s = 0;
    for (const vectorField* normals : {&cornerNormals[p], &polygonNormals[p]})
    {
        for (const vector& n : *normals)
        {
            const scalar dn = d & n;

            if (dn < smallest)
            {
                s = max(s, (smallest - dn)/max((cone.axis & n) - dn, VSMALL));
            }
        }
    }

    return normalised(d + min(s, scalar(1))*(cone.axis - d));
}


// * * * * * * * * * * * * *  Make Wall Visibility * * * * * * * * * * * * * //

//- Add the reflections in the side patches of a point, in order of rotation: in
//  the one on which the last edge is, then of all in the one of the first
static void addReflections
(
    const wallSurface& wall,
    const labelUList& sides,
    const label p,
    DynamicField<vector>& normals,
    DynamicField<scalar>& angles,
    DynamicField<vector>& others
)
{
    for (label k = sides.size() - 1; k >= 0; --k)
    {
        const sidePlane side
        (
            wall.border.sides[sides[k]].planeAt(wall.points[p])
        );

        for (label i = normals.size() - 1; i >= 0; --i)
        {
            normals.append(side.reflected(normals[i]));
            angles.append(scalar(angles[i]));
        }
        for (label i = others.size() - 1; i >= 0; --i)
        {
            others.append(side.reflected(others[i]));
        }
    }
}


//- Along the line or curve of two side patches; zero if they are in one plane
static vector commonLine
(
    const sidePatch& first,
    const sidePatch& second,
    const point& x,
    const UList<vector>& normals
)
{
    if (first.isCurved() || second.isCurved())
    {
        return sideCurve(first, second, x).tangent();
    }

    const vector line = first.normal ^ second.normal;

    return (line & sum(normals)) < 0 ? -line : line;
}


//- Set the line of a point on two side patches that are not in one plane
static void setSideLine
(
    const wallSurface& wall,
    const labelUList& sides,
    const label p,
    const UList<vector>& normals,
    wallVisibility& visibility
)
{
    if (sides.size() < 2)
    {
        return;
    }

    const List<sidePatch>& all = wall.border.sides;
    const vector line
    (
        commonLine(all[sides[0]], all[sides[1]], wall.points[p], normals)
    );

    if (magSqr(line) > visibilityControls::rounding)
    {
        visibility.sideLines.setSize(wall.points.size(), vector::zero);
        visibility.sideLines[p] = normalised(line);
    }
}


//- Set the normals and the cone of point p
static void setPoint
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const vectorField& faceNormals,
    const label p,
    wallVisibility& visibility
)
{
    DynamicField<vector> normals;
    DynamicField<scalar> angles;
    DynamicField<vector> others;

    for (const label facei : addressing.pointFaces[p])
    {
        // Faces between columns have no area
        if (wall.patchIDs[facei] < 0)
        {
            continue;
        }

        const face& f = wall.faces[facei];
        const label corner = f.find(p);
        const vector next = wall.points[f.nextLabel(corner)] - wall.points[p];
        const vector prev = wall.points[f.prevLabel(corner)] - wall.points[p];
        const vector n = next ^ prev;
        const scalar angle = ::atan2(mag(n), next & prev);

        // At a reflex corner of a polygon the edges span the outside
        const vector& faceNormal = faceNormals[facei];
        const bool reflex = (n & faceNormal) < 0;

        normals.append(normalised((n & faceNormal) > 0 ? n : faceNormal));
        angles.append(reflex ? constant::mathematical::twoPi - angle : angle);
        others.append(polygonNormals(wall, facei, p));
    }

    // A column of a fan has no faces of the wall
    if (normals.empty())
    {
        return;
    }

    const labelList sides(addressing.sidesOf(p));
    addReflections(wall, sides, p, normals, angles, others);
    setSideLine(wall, sides, p, normals, visibility);
    visibility.polygonNormals[p] = others;
    visibility.cornerNormals[p] = normals;
    visibility.meanNormals[p] = sum(angles*normals)/max(sum(angles), VSMALL);
    visibility.setCone(p);
}


vectorField polygonNormals
(
    const wallSurface& wall,
    const label facei,
    const label p
)
{
    const face& f = wall.faces[facei];
    const point& a = wall.points[f[0]];
    DynamicField<vector> normals;

    if (f.size() == 3)
    {
        return vectorField(std::move(normals));
    }

    normals.append(f.unitNormal(wall.points));

    for (label k = 2; k < f.size(); ++k)
    {
        if (p != f[0] && p != f[k - 1] && p != f[k])
        {
            continue;
        }

        // Three points in a line have none
        const vector n = normalised
        (
            (wall.points[f[k - 1]] - a) ^ (wall.points[f[k]] - a)
        );
        if (mag(n) > 0)
        {
            normals.append(n);
        }
    }

    return vectorField(std::move(normals));
}


wallVisibility makeWallVisibility
(
    const wallSurface& wall,
    const wallAddressing& addressing
)
{
    const label nPoints = wall.points.size();
    const vectorField faceNormals(wall.faceNormals());

    wallVisibility visibility;
    visibility.cornerNormals.setSize(nPoints);
    visibility.meanNormals.setSize(nPoints);
    visibility.polygonNormals.setSize(nPoints);
    visibility.cones.setSize(nPoints);

    // The first point on two side patches makes the lines of all
    const bool isClosed = addressing.pointSides.empty();

    #pragma omp parallel for schedule(static, 256) if (isClosed)
    for (label p = 0; p < nPoints; ++p)
    {
        if (addressing.pointFaces[p].size())
        {
            setPoint(wall, addressing, faceNormals, p, visibility);
        }
    }

    return visibility;
}


labelList pointsWithEmptyCones(const wallSurface& wall)
{
    return makeWallVisibility(wall, makeWallAddressing(wall)).emptyCones();
}


// * * * * * * * * * * * * * *  Cut Blind Faces  * * * * * * * * * * * * * * //

//- The polygons at points
static boolList polygonsAt(const wallSurface& wall, const labelUList& points)
{
    boolList isAsked(wall.points.size(), false);
    UIndirectList<bool>(isAsked, points) = true;
    boolList result(wall.faces.size());
    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];
        result[facei] = f.size() > 3
         && anyOf(f, [&](const label p) { return isAsked[p]; });
    }

    return result;
}


label cutBlindFaces(wallSurface& wall)
{
    const bool hasPolygons =
        anyOf(wall.faces, [](const face& f) { return f.size() > 3; });
    const labelList blind
    (
        hasPolygons ? pointsWithEmptyCones(wall) : labelList()
    );
    if (blind.empty())
    {
        return 0;
    }

    wallSurface trial(wall);
    cutFaces(trial, polygonsAt(wall, blind));
    const labelList stillBlind(pointsWithEmptyCones(trial));
    labelList cured(blind);
    inplaceSubsetList
    (
        cured, [&](const label p) { return !stillBlind.found(p); }
    );

    return cutFaces(wall, polygonsAt(wall, cured));
}

} // End namespace Foam

// ************************************************************************* //
