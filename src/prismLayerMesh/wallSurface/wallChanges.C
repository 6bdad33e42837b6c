/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallChanges.H"
#include "boundBox.H"
#include "DynamicList.H"
#include "edgeHashes.H"
#include "labelledTriangle.H"
#include "ranges.H"
#include "wallSides.H"

#include <functional>

namespace Foam
{

//- Smallest cosine between the normals of a corner and of its face
static const scalar smallestCosine = 0.5;


static bool hasReflexOrFoldedCorner(const face& f, const pointField& points)
{
    const vector normal(normalised(f.areaNormal(points)));

    forAll(f, i)
    {
        const vector next = points[f.nextLabel(i)] - points[f[i]];
        const vector prev = points[f.prevLabel(i)] - points[f[i]];

        const vector corner(next ^ prev);

        if ((corner & normal) <= smallestCosine*mag(corner))
        {
            return true;
        }
    }

    return false;
}


//- As cutFaces.
//  cut: returns the triangles of a face
static label cutFacesBy
(
    wallSurface& wall,
    const boolList& isCut,
    const std::function<faceList(const face&)>& cut
)
{
    if (!isCut.found(true))
    {
        return 0;
    }

    DynamicList<face> kept(wall.faces.size()), triangles;
    DynamicList<label> keptIDs(wall.faces.size()), triangleIDs;

    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];
        if (!isCut[facei])
        {
            kept.append(f);
            keptIDs.append(wall.patchIDs[facei]);
            continue;
        }

        for (const face& part : cut(f))
        {
            triangles.append(part);
            triangleIDs.append(wall.patchIDs[facei]);
        }
    }

    const label nCut = wall.faces.size() - kept.size();
    kept.append(triangles);
    keptIDs.append(triangleIDs);
    wall.faces.transfer(kept);
    wall.patchIDs.transfer(keptIDs);

    return nCut;
}


label cutFaces(wallSurface& wall, const boolList& isCut)
{
    return cutFacesBy(wall, isCut, [&](const face& f)
    {
        faceList parts(f.nTriangles());
        label n = 0;
        f.triangles(wall.points, n, parts);

        return parts;
    });
}


label cutReflexFaces(wallSurface& wall)
{
    boolList isCut(wall.faces.size());
    forAll(isCut, facei)
    {
        const face& f = wall.faces[facei];

        // One without area is left for findWallDefects
        isCut[facei] = f.size() > 3 && f.mag(wall.points) >= VSMALL
         && hasReflexOrFoldedCorner(f, wall.points);
    }

    return cutFaces(wall, isCut);
}


//- The fan of triangles of a face from its corner k
static faceList fanFrom(const face& f, const label k)
{
    faceList fan(f.size() - 2);
    forAll(fan, i)
    {
        fan[i] = face
        ({
            f[k], f[(k + i + 1) % f.size()], f[(k + i + 2) % f.size()]
        });
    }

    return fan;
}


label cutCrowdedFaces(wallSurface& wall)
{
    // The fans from other corners count as further faces
    const label n = wall.faces.size();
    DynamicList<face> others;
    DynamicList<label> otherFaces;
    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];
        for (label k = 1; f.size() > 3 && k < f.size(); ++k)
        {
            const faceList fan(fanFrom(f, k));
            others.append(fan);
            otherFaces.append(labelList(fan.size(), n + facei));
        }
    }
    if (others.empty())
    {
        return 0;
    }

    labelList wallFaces;
    const faceList triangles(wallTriangles(wall, wallFaces));
    DynamicList<labelPair> pairs;
    addIntersections
    (
        labelledTriangles(others, wall.points, otherFaces),
        labelledTriangles(triangles, wall.points, wallFaces),
        pairs
    );

    boolList isCut(n, false);
    for (const labelPair& pair : pairs)
    {
        for (const label facei : pair)
        {
            if (facei >= n && pair.first() % n != pair.second() % n)
            {
                isCut[facei - n] = true;
            }
        }
    }

    return cutFacesBy
    (
        wall, isCut, [](const face& f) { return fanFrom(f, 0); }
    );
}


// * * * * * * * * * * * * * * * *  Flip Caps  * * * * * * * * * * * * * * * //

//- The edge to flip if a face is a cap, otherwise an edge without points
static edge edgeOfCap
(
    const pointField& points,
    const face& f,
    const scalar distance
)
{
    if (f.size() != 3)
    {
        return edge();
    }

    const label longest = f.longestEdge(points);
    const edge e(f.faceEdge(longest));
    const vector along(e.vec(points));
    const vector side(points[f.prevLabel(longest)] - points[e[0]]);
    const scalar share = (side & along)/max(magSqr(along), VSMALL);
    const bool isCap =
        share > 0 && share < 1 && mag(side - share*along) < distance;

    return isCap ? e : edge();
}


namespace
{

class capFlipper
{
    wallSurface& wall_;
    edgeHashSet edges_;

    //- Points around which something has changed
    bitSet isTouched_;

    bool isTouched(const face& f) const
    {
        return anyOf(f, [&](const label p) { return isTouched_.test(p); });
    }

public:

    explicit capFlipper(wallSurface& wall)
    :
        wall_(wall),
        isTouched_(wall.points.size())
    {
        for (const face& f : wall.faces)
        {
            edges_.insert(f.edges());
        }
    }

    //- Flips an edge of a cap. False if it stays.
    bool flip(const edge& e, label cap, label neighbour);
};


bool capFlipper::flip(const edge& e, const label cap, const label neighbour)
{
    face& f = wall_.faces[cap];
    face& g = wall_.faces[neighbour];
    if (g.size() != 3 || isTouched(f) || isTouched(g))
    {
        return false;
    }

    const edgeFlip flipped(f, g, e);
    const edge& made = flipped.made;
    if
    (
        made[0] == made[1] || edges_.found(made)
     || !flipped.isBetter(wall_.points)
    )
    {
        return false;
    }

    edges_.erase(e);
    edges_.insert(made);
    isTouched_.set(e);
    isTouched_.set(made);
    f = flipped.first;
    g = flipped.second;
    wall_.patchIDs[cap] = wall_.patchIDs[neighbour];

    return true;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

edgeFlip::edgeFlip(const face& f, const face& g, const edge& e)
:
    f(f),
    g(g),
    made(f.prevLabel(f.find(e[0])), g.prevLabel(g.find(e[1]))),
    first({e[0], made[1], made[0]}),
    second({made[1], e[1], made[0]})
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool edgeFlip::isBetter(const pointField& points) const
{
    const auto height = [&](const face& a, const face& b)
    {
        return min(smallestHeight(points, a), smallestHeight(points, b));
    };

    return isAlong(points, g, first) && isAlong(points, g, second)
        && height(first, second) > height(f, g);
}


scalar smallestHeight(const pointField& points, const face& f)
{
    const scalar longest = f.faceEdge(f.longestEdge(points)).mag(points);

    return 2*f.mag(points)/max(longest, VSMALL);
}


bool isAlong(const pointField& points, const face& f, const face& g)
{
    const vector a(f.areaNormal(points));
    const vector b(g.areaNormal(points));

    return (a & b) > 0.5*mag(a)*mag(b) && mag(b) > 0;
}


label flipCaps(wallSurface& wall, const scalar tolerance)
{
    const scalar distance = tolerance*boundBox(wall.points, false).mag();
    label nFlips = 0;

    for (label before = -1; before != nFlips;)
    {
        before = nFlips;
        Map<edge> caps;
        forAll(wall.faces, facei)
        {
            const edge e(edgeOfCap(wall.points, wall.faces[facei], distance));
            if (e.valid())
            {
                caps.insert(facei, e);
            }
        }
        if (caps.empty())
        {
            break;
        }

        const wallSides sides(makeWallSides(wall));
        capFlipper flipper(wall);
        for (label i = 0; i < sides.nEdges(); ++i)
        {
            const SubList<wallSide> on(sides.on(i));
            if (on.size() != 2)
            {
                continue;
            }
            for (label k = 0; k < 2; ++k)
            {
                const auto cap = caps.cfind(on[k].facei);
                if (cap.good() && cap.val() == on[k].along())
                {
                    nFlips +=
                        flipper.flip(cap.val(), on[k].facei, on[1 - k].facei);
                }
            }
        }
    }

    return nFlips;
}

} // End namespace Foam

// ************************************************************************* //
