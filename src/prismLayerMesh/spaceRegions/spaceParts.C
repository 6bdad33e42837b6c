/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "spaceParts.H"
#include "boundBox.H"
#include "cellPredicates.H"
#include "disjointSets.H"
#include "DynamicList.H"
#include "ListOps.H"
#include "wallSides.H"

#include <algorithm>
#include <random>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The point of a triangle that is not on an edge
static label apexOf(const face& f, const wallSide& side)
{
    for (const label p : f)
    {
        if (p != side.low && p != side.high)
        {
            return p;
        }
    }

    return -1;
}


namespace
{

//- Triangles at an edge in their order around it, counter-clockwise about the
//  direction from its low to its high point, by exact predicates
class edgeOrder
{
    const pointField& x_;
    const faceList& faces_;
    const point& a_;
    const point& b_;
    const wallSide& first_;

    const point& apex(const wallSide& side) const
    {
        return x_[apexOf(faces_[side.facei], side)];
    }

    //- Whether a triangle in the plane of the first one is on its other side
    bool isOpposite(const wallSide& side) const
    {
        const vector along(b_ - a_);
        const vector u(apex(first_) - a_);
        const vector v(apex(side) - a_);

        return (u & v)*magSqr(along) - (u & along)*(v & along) < 0;
    }

    //- 0: at the first triangle; 1: within half a turn from it; 2: in its plane
    //  beyond the edge; 3: behind
    int sector(const wallSide& side) const
    {
        if (&side == &first_ || side.facei == first_.facei)
        {
            return 0;
        }
        const int sign = orientation(a_, b_, apex(first_), apex(side));

        return sign > 0 ? 1 : sign < 0 ? 3 : isOpposite(side) ? 2 : 0;
    }

public:

    edgeOrder
    (
        const wallSurface& surface,
        const wallSide& first
    )
    :
        x_(surface.points),
        faces_(surface.faces),
        a_(x_[first.low]),
        b_(x_[first.high]),
        first_(first)
    {}

    //- Whether f comes before g
    bool operator()(const wallSide& f, const wallSide& g) const
    {
        const int s = sector(f);
        const int t = sector(g);

        return
            s != t ? s < t
          : (s == 1 || s == 3) && orientation(a_, b_, apex(f), apex(g)) > 0;
    }
};


//- The corners of the sides of triangles: corner k of side s is 3*s + k
label cornerAt(const faceList& faces, const label side, const label p)
{
    return 3*side + faces[side/2].find(p);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void spaceParts::setAcross()
{
    const faceList& faces = surface_.faces;
    across_.setSize(2*faces.size());
    const wallSides sides(makeWallSides(surface_));

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> on(sides.on(e));
        const edgeOrder before(surface_, on[0]);
        std::vector<wallSide> order(on.begin(), on.end());
        std::sort(order.begin(), order.end(), before);

        for (std::size_t i = 0; i < order.size(); ++i)
        {
            const wallSide& f = order[i];
            const wallSide& g = order[(i + 1) % order.size()];
            if (i + 1 < order.size() && !before(f, g))
            {
                FatalErrorInFunction
                    << "Two triangles cover each other, at "
                    << faces[f.facei].centre(surface_.points)
                    << exit(FatalError);
            }

            // The fronts of triangles that run up the edge are ahead of them
            const label ahead = 2*f.facei + (f.up ? 0 : 1);
            const label back = 2*g.facei + (g.up ? 1 : 0);
            across_[ahead][faces[f.facei].find(f.along().start())] = back;
            across_[back][faces[g.facei].find(g.along().start())] = ahead;
        }
    }
}


spaceParts::rayHits spaceParts::findHits(const point& x) const
{
    const pointField& p = surface_.points;
    std::mt19937 random(1);
    std::uniform_real_distribution<scalar> share(-1, 1);

    const auto goThrough = [&](const point& y, rayHits& hits)
    {
        forAll(surface_.faces, i)
        {
            const face& f = surface_.faces[i];
            const point& a = p[f[0]];
            const point& b = p[f[1]];
            const point& c = p[f[2]];
            const int side = orientation(a, b, c, x);
            const int sideOfEnd = orientation(a, b, c, y);
            if (side && side == sideOfEnd)
            {
                continue;
            }
            const int ab = orientation(x, y, a, b);
            const int bc = orientation(x, y, b, c);
            const int ca = orientation(x, y, c, a);
            if (max(ab, max(bc, ca)) > 0 && min(ab, min(bc, ca)) < 0)
            {
                continue;
            }
            if (!side || !sideOfEnd || !ab || !bc || !ca)
            {
                return false;
            }

            const vector n((b - a) ^ (c - a));
            hits[((a - x) & n)/((y - x) & n)] = i;
        }

        return true;
    };

    // Rays that are as long reach out of the surface
    const scalar length = 4*boundBox(p, false).mag();
    static constexpr label maxRays = 100;
    for (label n = 0; n < maxRays; ++n)
    {
        vector ray(share(random), share(random), share(random));
        ray *= length/max(mag(ray), SMALL);
        rayHits hits;
        if (goThrough(x + ray, hits))
        {
            return hits;
        }
    }

    FatalErrorInFunction
        << "The point " << x << " is on the surface" << nl
        << "Choose a point off the surface: the entry inside of a region"
        << exit(FatalError);

    return rayHits();
}


label spaceParts::sideSeen(const label i, const point& from) const
{
    const pointField& x = surface_.points;
    const face& f = surface_.faces[i];

    return 2*i + (orientation(x[f[0]], x[f[1]], x[f[2]], from) > 0 ? 0 : 1);
}


void spaceParts::joinShells(labelList& shellOfSide, const label nShells) const
{
    // Shell nShells is around all
    const faceList& faces = surface_.faces;
    disjointSets parts(nShells + 1);

    // Pieces that touch in points alone have shells of their own
    labelList pieceOf;
    const label nPieces =
        findComponents(makeWallSides(surface_), faces.size(), pieceOf);
    boolList isDone(nPieces, false);
    const scalar size = boundBox(surface_.points, false).mag();

    forAll(faces, i)
    {
        if (isDone[pieceOf[i]])
        {
            continue;
        }
        isDone[pieceOf[i]] = true;

        // From in front of the triangle out of the surface. Sides that follow
        // each other along the ray are in one part.
        const vector n(faces[i].unitNormal(surface_.points));
        const point x(faces[i].centre(surface_.points) + 1e-9*size*n);
        label shell = shellOfSide[2*i];
        for (const auto& hit : findHits(x))
        {
            const label side = sideSeen(hit.second, x);
            parts.join(shell, shellOfSide[side]);
            shell = shellOfSide[side ^ 1];
        }
        parts.join(shell, nShells);
    }

    // -1: the set with the shell around all
    const label outside = parts.find(nShells);
    for (label& shell : shellOfSide)
    {
        shell = parts.find(shell);
        shell = shell == outside ? -1 : shell;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

spaceParts::spaceParts(const wallSurface& surface)
:
    surface_(surface)
{
    setAcross();

    const label nSides = across_.size();
    disjointSets shells(nSides);
    forAll(across_, s)
    {
        for (const label other : across_[s])
        {
            shells.join(s, other);
        }
    }
    labelList number(nSides, -1);
    label nShells = 0;
    partOfSide_.setSize(nSides);
    forAll(partOfSide_, s)
    {
        label& n = number[shells.find(s)];
        n = n < 0 ? nShells++ : n;
        partOfSide_[s] = n;
    }

    joinShells(partOfSide_, nShells);
    labelList partOfShell(nShells, -1);
    for (label& part : partOfSide_)
    {
        if (part < 0)
        {
            part = 0;
            continue;
        }
        label& n = partOfShell[part];
        n = n < 0 ? nParts_++ : n;
        part = n;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label spaceParts::partAt(const point& x) const
{
    const rayHits hits(findHits(x));

    return hits.empty() ? 0 : partOfSide_[sideSeen(hits.begin()->second, x)];
}


wallSurface spaceParts::boundaryOf
(
    const label parti,
    labelList& points,
    labelList& faces
) const
{
    const labelList sides(findIndices(partOfSide_, parti));
    disjointSets corners(3*across_.size());
    for (const label s : sides)
    {
        const face& f = surface_.faces[s/2];
        forAll(f, k)
        {
            const label other = across_[s][k];
            for (const label p : {f[k], f.nextLabel(k)})
            {
                corners.join
                (
                    cornerAt(surface_.faces, s, p),
                    cornerAt(surface_.faces, other, p)
                );
            }
        }
    }

    wallSurface boundary;
    boundary.patchNames = surface_.patchNames;
    DynamicList<label> pointLabels;
    labelList numbers(3*across_.size(), -1);
    faces.setSize(sides.size());
    boundary.faces.setSize(sides.size());
    boundary.patchIDs.setSize(sides.size());
    forAll(sides, i)
    {
        const label s = sides[i];
        faces[i] = s/2;
        boundary.patchIDs[i] = surface_.patchIDs[s/2];
        face f(surface_.faces[s/2]);
        forAll(f, k)
        {
            label& n = numbers[corners.find(3*s + k)];
            if (n < 0)
            {
                n = pointLabels.size();
                pointLabels.append(f[k]);
            }
            f[k] = n;
        }
        boundary.faces[i] = s % 2 ? f.reverseFace() : f;
    }
    points.transfer(pointLabels);
    boundary.points = pointField(surface_.points, points);

    return boundary;
}


scalar spaceParts::volumeOf(const label parti) const
{
    // Normals point into the part
    scalar sum = 0;
    const point origin(boundBox(surface_.points, false).midpoint());
    forAll(partOfSide_, s)
    {
        if (partOfSide_[s] == parti)
        {
            const face& f = surface_.faces[s/2];
            const vector a(surface_.points[f[0]] - origin);
            const vector b(surface_.points[f[1]] - origin);
            const vector c(surface_.points[f[2]] - origin);
            sum += (s % 2 ? 1 : -1)*(a & (b ^ c))/6;
        }
    }

    return sum;
}

} // End namespace Foam

// ************************************************************************* //
