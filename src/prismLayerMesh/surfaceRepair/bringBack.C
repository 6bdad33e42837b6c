/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bringBack.H"
#include "cutSurface.H"
#include "unitConversion.H"
#include "wallVisibility.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Passes over faces at fault, more than it ever takes: each point is held back
//  three times at most
static constexpr label maxPasses = 50;

//- Rounds in which points that were held back are tried again
static constexpr label maxTries = 20;

//- Least angle [deg] between the axis of a point's visibility cone and a face:
//  layers can begin there
static constexpr scalar smallestAngle = 10;

//- Least height of a triangle over its longest edge
static constexpr scalar leastHeight = 0.1;

//- The share of angles and heights in the wrap that is enough, where it has
//  smaller ones
static constexpr scalar keptShare = 0.5;


namespace
{

class returner
{
    const wrapTargets targets_;
    wallSurface& wrap_;
    const wallAddressing addressing_;

    //- How far each point is held back
    labelList held_;

    //- The least for each triangle and point
    scalarField leastHeights_;
    scalarField leastSines_;


    void hold(const label p, const label held)
    {
        held_[p] = held;
        wrap_.points[p] = targets_.at(p, held);
    }

    bool isOnEdge(const label p) const
    {
        return held_[p] == wrapTargets::none && targets_.hasEdge(p);
    }

    //- Returns the height of each triangle over its longest edge
    scalarField heights() const;

    //- Returns for each point the sine of the smallest angle between the axis
    //  of its visibility cone and a face
    scalarField sines() const;

    //- Faces that are flatter than they may be, or around points with narrower
    //  visibility cones
    labelList poorFaces() const;

    //- Points of faces at fault: those of side patches only where faces
    //  intersect, and of a face only those that go to sharp edges, if it has
    //  any and they are first
    bitSet pointsAtFault(const bool edgesFirst) const;

    //- Hold points back until no faces are at fault
    void holdBack();

    //- Points held back that were not tried again, never two of one face
    labelList someHeldBack(bitSet& tried) const;

    //- Let points go to where they belong, if they can; whether any can
    bool release(const labelList& some);

    //- Try points again that were held back because of others
    void tryAgain();

public:

    returner
    (
        const wallSurface& surface,
        const nearestSurface& nearest,
        const returnControls& controls,
        wallSurface& wrap
    )
    :
        targets_(surface, nearest, controls, wrap),
        wrap_(wrap),
        addressing_(makeWallAddressing(wrap)),
        held_(wrap.points.size(), label(wrapTargets::none)),
        leastHeights_(min(keptShare*heights(), leastHeight)),
        leastSines_(sines())
    {
        // Faces around points with very narrow cones stay as they are
        const scalar least = Foam::sin(degToRad(smallestAngle));
        for (scalar& sine : leastSines_)
        {
            sine = min(max(keptShare*sine, sqr(keptShare)*least), least);
        }
    }

    broughtBack move();
};


scalarField returner::heights() const
{
    scalarField heights(wrap_.faces.size());

    forAll(heights, facei)
    {
        const face& f = wrap_.faces[facei];
        const scalar longest =
            f.faceEdge(f.longestEdge(wrap_.points)).mag(wrap_.points);
        heights[facei] = 2*f.mag(wrap_.points)/max(sqr(longest), VSMALL);
    }

    return heights;
}


scalarField returner::sines() const
{
    const wallVisibility visibility(makeWallVisibility(wrap_, addressing_));
    scalarField sines(visibility.cones.size());

    forAll(sines, p)
    {
        sines[p] = visibility.cones[p].cosine;
    }

    return sines;
}


labelList returner::poorFaces() const
{
    bitSet fault(wrap_.faces.size());

    const scalarField now(heights());
    forAll(now, facei)
    {
        if (now[facei] < leastHeights_[facei])
        {
            fault.set(facei);
        }
    }

    const scalarField sinesNow(sines());
    forAll(sinesNow, p)
    {
        if (sinesNow[p] < leastSines_[p])
        {
            fault.set(addressing_.pointFaces[p]);
        }
    }

    return fault.sortedToc();
}


bitSet returner::pointsAtFault(const bool edgesFirst) const
{
    bitSet all(held_.size());
    const auto add = [&](const labelList& faces, const bitSet& but)
    {
        for (const label facei : faces)
        {
            const face& f = wrap_.faces[facei];
            const bool onlyOnEdges = edgesFirst && std::any_of
            (
                f.begin(), f.end(), [&](const label p) { return isOnEdge(p); }
            );

            for (const label p : f)
            {
                if (!but.test(p) && (isOnEdge(p) || !onlyOnEdges))
                {
                    all.set(p);
                }
            }
        }
    };

    add(facesInConflict(wrap_), bitSet());
    add(poorFaces(), targets_.onSides());

    return all;
}


void returner::holdBack()
{
    bool changed = true;

    for (label pass = 0; changed && pass < maxPasses; ++pass)
    {
        changed = false;
        for (const label p : pointsAtFault(true))
        {
            if (held_[p] < wrapTargets::atWrap)
            {
                const bool next = held_[p] || targets_.hasEdge(p);
                hold(p, held_[p] + (next ? 1 : 2));
                changed = true;
            }
        }
    }
}


labelList returner::someHeldBack(bitSet& tried) const
{
    bitSet beside(held_.size());
    DynamicList<label> some;

    forAll(held_, p)
    {
        const bool canMove = targets_.hasEdge(p) || !targets_.stays(p);

        if (held_[p] && canMove && !tried.test(p) && !beside.test(p))
        {
            some.append(p);
            tried.set(p);
            beside.set(addressing_.pointPoints[p]);
        }
    }

    return labelList(std::move(some));
}


bool returner::release(const labelList& some)
{
    const labelList before(UIndirectList<label>(held_, some));
    for (const label p : some)
    {
        hold(p, wrapTargets::none);
    }

    label nFree = some.size();
    bool changed = nFree;
    while (changed)
    {
        changed = false;
        const bitSet fault(pointsAtFault(false));
        forAll(some, i)
        {
            if (held_[some[i]] != before[i] && fault.test(some[i]))
            {
                hold(some[i], before[i]);
                changed = true;
                --nFree;
            }
        }
    }

    return nFree;
}


void returner::tryAgain()
{
    bitSet tried(held_.size());
    bool anyFree = false;

    for (label round = 0; round < maxTries; ++round)
    {
        labelList some(someHeldBack(tried));
        if (some.empty() && anyFree)
        {
            // Points may have kept others back
            tried.reset();
            anyFree = false;
            some = someHeldBack(tried);
        }
        if (some.empty())
        {
            break;
        }

        anyFree = release(some) || anyFree;
    }
}


broughtBack returner::move()
{
    forAll(held_, p)
    {
        hold(p, wrapTargets::none);
    }
    holdBack();
    tryAgain();

    broughtBack result;
    forAll(held_, p)
    {
        ++
        (
            isOnEdge(p) ? result.nOnEdges
          : held_[p] == wrapTargets::atWrap || targets_.stays(p) ? result.nLeft
          : held_[p] == wrapTargets::between ? result.nBetween
          : result.nOnFaces
        );
    }

    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

broughtBack bringBack
(
    const wallSurface& surface,
    const nearestSurface& nearest,
    const returnControls& controls,
    wallSurface& wrap
)
{
    return returner(surface, nearest, controls, wrap).move();
}

} // End namespace Foam

// ************************************************************************* //
