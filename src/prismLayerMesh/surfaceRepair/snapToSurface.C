/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "snapToSurface.H"
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

class wrapSnapper
{
    const wrapTargets targets_;
    wallSurface& wrap_;
    const wallAddressing addressing_;

    //- How far each point goes
    List<snapping> snapping_;

    //- The least for each triangle and point
    scalarField leastHeights_;
    scalarField leastSines_;


    void snap(const label p, const snapping how)
    {
        snapping_[p] = how;
        wrap_.points[p] = targets_.at(p, how);
    }

    bool isOnEdge(const label p) const
    {
        return snapping_[p] == snapping::full && targets_.hasEdge(p);
    }

    //- How far a point goes if it is held back one more time
    snapping reduced(const label p) const;

    //- Returns the height of each triangle over its longest edge
    scalarField heights() const;

    //- Returns for each point the sine of the smallest angle between the axis
    //  of its visibility cone and a face
    scalarField sines() const;

    //- Faces that are flatter than they may be, or around points with narrower
    //  visibility cones
    labelList facesAtFault() const;

    //- Points of faces at fault: those of side patches only where faces
    //  intersect, and of a face only those that go to sharp edges, if it has
    //  any and they are first
    bitSet pointsAtFault(const bool edgesFirst) const;

    //- Hold points back until no faces are at fault
    void holdBack();

    //- Points held back that were not tried again, never two of one face
    labelList heldBackApart(bitSet& tried) const;

    //- Snap points fully, except those that then are of faces at fault;
    //  whether any point stays snapped
    bool snapFully(const labelList& points);

    //- Try points again that were held back because of others
    void tryAgain();

public:

    wrapSnapper
    (
        const wallSurface& surface,
        const nearestSurface& nearest,
        const snapControls& controls,
        wallSurface& wrap
    )
    :
        targets_(surface, nearest, controls, wrap),
        wrap_(wrap),
        addressing_(makeWallAddressing(wrap)),
        snapping_(wrap.points.size(), snapping::full),
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

    snapCounts snap();
};


snapping wrapSnapper::reduced(const label p) const
{
    switch (snapping_[p])
    {
        case snapping::full:
            return targets_.hasEdge(p) ? snapping::toFace : snapping::halfWay;

        case snapping::toFace:
            return snapping::halfWay;

        default:
            return snapping::none;
    }
}


scalarField wrapSnapper::heights() const
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


scalarField wrapSnapper::sines() const
{
    const wallVisibility visibility(makeWallVisibility(wrap_, addressing_));
    scalarField sines(visibility.cones.size());

    forAll(sines, p)
    {
        sines[p] = visibility.cones[p].cosine;
    }

    return sines;
}


labelList wrapSnapper::facesAtFault() const
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


bitSet wrapSnapper::pointsAtFault(const bool edgesFirst) const
{
    bitSet all(snapping_.size());
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
    add(facesAtFault(), targets_.onSides());

    return all;
}


void wrapSnapper::holdBack()
{
    bool changed = true;

    for (label pass = 0; changed && pass < maxPasses; ++pass)
    {
        changed = false;
        for (const label p : pointsAtFault(true))
        {
            if (snapping_[p] != snapping::none)
            {
                snap(p, reduced(p));
                changed = true;
            }
        }
    }
}


labelList wrapSnapper::heldBackApart(bitSet& tried) const
{
    bitSet beside(snapping_.size());
    DynamicList<label> apart;

    forAll(snapping_, p)
    {
        const bool isHeldBack = snapping_[p] != snapping::full;
        const bool canMove = targets_.hasEdge(p) || !targets_.stays(p);

        if (isHeldBack && canMove && !tried.test(p) && !beside.test(p))
        {
            apart.append(p);
            tried.set(p);
            beside.set(addressing_.pointPoints[p]);
        }
    }

    return labelList(std::move(apart));
}


bool wrapSnapper::snapFully(const labelList& points)
{
    const List<snapping> before(UIndirectList<snapping>(snapping_, points));
    for (const label p : points)
    {
        snap(p, snapping::full);
    }

    label nSnapped = points.size();
    bool changed = nSnapped;
    while (changed)
    {
        changed = false;
        const bitSet fault(pointsAtFault(false));
        forAll(points, i)
        {
            if (snapping_[points[i]] != before[i] && fault.test(points[i]))
            {
                snap(points[i], before[i]);
                changed = true;
                --nSnapped;
            }
        }
    }

    return nSnapped;
}


void wrapSnapper::tryAgain()
{
    bitSet tried(snapping_.size());
    bool anySnapped = false;

    for (label round = 0; round < maxTries; ++round)
    {
        labelList points(heldBackApart(tried));
        if (points.empty() && anySnapped)
        {
            // Points may have kept others back
            tried.reset();
            anySnapped = false;
            points = heldBackApart(tried);
        }
        if (points.empty())
        {
            break;
        }

        anySnapped = snapFully(points) || anySnapped;
    }
}


snapCounts wrapSnapper::snap()
{
    forAll(snapping_, p)
    {
        snap(p, snapping::full);
    }
    holdBack();
    tryAgain();

    snapCounts counts;
    forAll(snapping_, p)
    {
        if (isOnEdge(p))
        {
            ++counts.nOnEdges;
        }
        else if (snapping_[p] == snapping::none || targets_.stays(p))
        {
            ++counts.nLeft;
        }
        else if (snapping_[p] == snapping::halfWay)
        {
            ++counts.nHalfWay;
        }
        else
        {
            ++counts.nOnFaces;
        }
    }

    return counts;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

snapCounts snapToSurface
(
    const wallSurface& surface,
    const nearestSurface& nearest,
    const snapControls& controls,
    wallSurface& wrap
)
{
    return wrapSnapper(surface, nearest, controls, wrap).snap();
}

} // End namespace Foam

// ************************************************************************* //
