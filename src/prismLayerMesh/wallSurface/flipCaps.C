/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flipCaps.H"
#include "boundBox.H"
#include "edgeHashes.H"
#include "wallSides.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The smallest height [m] of a triangle
static scalar heightOf(const pointField& points, const face& f)
{
    const scalar longest = f.faceEdge(f.longestEdge(points)).mag(points);

    return 2*f.mag(points)/max(longest, VSMALL);
}


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
        return std::any_of
        (
            f.begin(), f.end(),
            [&](const label p) { return isTouched_.test(p); }
        );
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


bool capFlipper::flip
(
    const edge& e,
    const label cap,
    const label neighbour
)
{
    face& f = wall_.faces[cap];
    face& g = wall_.faces[neighbour];
    if (g.size() != 3 || isTouched(f) || isTouched(g))
    {
        return false;
    }

    const label v = f.prevLabel(f.find(e[0]));
    const label w = g.prevLabel(g.find(e[1]));
    const face first({e[0], w, v});
    const face second({w, e[1], v});
    const auto height = [&](const face& a, const face& b)
    {
        return min(heightOf(wall_.points, a), heightOf(wall_.points, b));
    };
    const vector before(g.unitNormal(wall_.points));
    const auto turns = [&](const face& after)
    {
        return (after.unitNormal(wall_.points) & before) < 0.5;
    };

    if
    (
        v == w || edges_.found(edge(v, w)) || turns(first) || turns(second)
     || height(first, second) <= height(f, g)
    )
    {
        return false;
    }

    edges_.erase(e);
    edges_.insert(edge(v, w));
    isTouched_.set(labelList({e[0], e[1], v, w}));
    f = first;
    g = second;
    wall_.patchIDs[cap] = wall_.patchIDs[neighbour];

    return true;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

        const wallSides sides(makeWallSides(wall.faces, wall.points.size()));
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
