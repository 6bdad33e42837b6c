/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "snapToSurface.H"
#include "cutSurface.H"
#include "stageProgress.H"
#include "wrapShape.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Passes over faces at fault, more than it ever takes: each point is held back
//  three times at most
static constexpr label maxPasses = 50;

//- Rounds in which points that were held back are tried again
static constexpr label maxTries = 20;


namespace
{

class wrapSnapper
{
    const wrapTargets targets_;
    wallSurface& wrap_;
    const wallAddressing addressing_;

    //- How far each point goes
    List<snapping> snapping_;

    const wrapShape shape_;


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
        shape_(wrap, addressing_)
    {}

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
    add(shape_.facesAtFault(wrap_), targets_.onSides());

    return all;
}


void wrapSnapper::holdBack()
{
    repeatUntilStable("holding points back", maxPasses, [&]()
    {
        bool changed = false;
        for (const label p : pointsAtFault(true))
        {
            if (snapping_[p] != snapping::none)
            {
                snap(p, reduced(p));
                changed = true;
            }
        }

        return changed;
    });
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

    repeatUntilStable("snapping points again", maxTries, [&]()
    {
        labelList points(heldBackApart(tried));
        if (points.empty() && anySnapped)
        {
            // Points may have kept others back
            tried.reset();
            anySnapped = false;
            points = heldBackApart(tried);
        }
        anySnapped = snapFully(points) || anySnapped;

        return points.size() > 0;
    });
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
