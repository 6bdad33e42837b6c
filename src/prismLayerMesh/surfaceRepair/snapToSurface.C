/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bitSet.H"
#include "boundBox.H"
#include "cutSurface.H"
#include "disjointSets.H"
#include "Map.H"
#include "ranges.H"
#include "stageProgress.H"
#include "unitConversion.H"
#include "wallVisibility.H"
#include "wrapSurface.H"

namespace Foam
{

//- A point is on a side of a face if the sine of its elevation is larger: not
//  beside an edge of the face
static constexpr scalar leastElevation = 0.5;

static constexpr label nPlaces = 10;


static void addFaces
(
    const wallSurface& surface,
    const bitSet& faces,
    repairSteps& steps
)
{
    DynamicList<point> places;
    scalar area = 0;
    scalar all = 0;

    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        all += f.mag(surface.points);

        if (faces.test(facei))
        {
            area += f.mag(surface.points);

            if (places.size() < nPlaces)
            {
                places.append(f.centre(surface.points));
            }
        }
    }

    OStringStream what;
    what.precision(3);
    what << "faces with the wrap on both sides, " << 100*area/all
        << " % of the area:";
    addStep(steps, what.str(), faces.count(), places);
}


static void addOpenings
(
    const wallSurface& surface,
    const scalar size,
    repairSteps& steps
)
{
    const edgeList open(outline(surface.faces));
    disjointSets loops(connectedPoints(surface.points.size(), open));

    Map<boundBox> boxes;
    for (const edge& e : open)
    {
        boundBox& box = boxes(loops.find(e.start()), boundBox());
        box.add(surface.points[e.start()]);
        box.add(surface.points[e.end()]);
    }

    DynamicList<point> places;
    label count = 0;
    for (const label root : boxes.sortedToc())
    {
        if (boxes[root].mag() > size)
        {
            ++count;
            if (places.size() < nPlaces)
            {
                places.append(boxes[root].centre());
            }
        }
    }
    addStep(steps, "openings wider than the size", count, places);
}


bitSet facesInside
(
    const wallSurface& surface,
    const nearestSurface& nearest,
    const wallSurface& wrap
)
{
    const vectorField normals(surface.faceNormals());
    pointField feet;
    labelList faces;
    nearest.find(wrap.points, feet, faces);
    bitSet front(surface.faces.size());
    bitSet back(surface.faces.size());

    forAll(feet, p)
    {
        const vector out(wrap.points[p] - feet[p]);
        const scalar height = out & normals[faces[p]];

        if (mag(height) > leastElevation*mag(out))
        {
            (height > 0 ? front : back).set(faces[p]);
        }
    }

    return front &= back;
}


void addLeaks
(
    const wallSurface& surface,
    const bitSet& inside,
    const scalar size,
    repairSteps& steps
)
{
    addFaces(surface, inside, steps);

    if (inside.any())
    {
        addOpenings(surface, size, steps);
    }
}


// * * * * * * * * * * * * * * *  Wrap Shape * * * * * * * * * * * * * * * * //

//- Least angle [deg] between the axis of a point's visibility cone and a face:
//  layers can begin there
static constexpr scalar smallestAngle = 10;

//- Least height of a triangle over its longest edge
static constexpr scalar leastHeight = 0.1;

//- The share of angles and heights in the wrap that is enough, where it has
//  smaller ones
static constexpr scalar keptShare = 0.5;


//- Returns the height of each triangle over its longest edge
static scalarField heightsOf(const wallSurface& wrap)
{
    scalarField heights(wrap.faces.size());
    forAll(heights, facei)
    {
        const face& f = wrap.faces[facei];
        const scalar longest =
            f.faceEdge(f.longestEdge(wrap.points)).mag(wrap.points);
        heights[facei] = 2*f.mag(wrap.points)/max(sqr(longest), VSMALL);
    }

    return heights;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

scalarField wrapShape::sines(const wallSurface& wrap) const
{
    const wallVisibility visibility(makeWallVisibility(wrap, addressing_));
    scalarField sines(visibility.cones.size());
    forAll(sines, p)
    {
        sines[p] = visibility.cones[p].cosine;
    }

    return sines;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

wrapShape::wrapShape(const wallSurface& wrap, const wallAddressing& addressing)
:
    addressing_(addressing),
    leastHeights_(min(keptShare*heightsOf(wrap), leastHeight)),
    leastSines_(sines(wrap))
{
    // Faces around points with very narrow cones stay as they are
    const scalar least = Foam::sin(degToRad(smallestAngle));
    for (scalar& sine : leastSines_)
    {
        sine = min(max(keptShare*sine, sqr(keptShare)*least), least);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList wrapShape::facesAtFault(const wallSurface& wrap) const
{
    bitSet fault(wrap.faces.size());

    const scalarField now(heightsOf(wrap));
    forAll(now, facei)
    {
        if (now[facei] < leastHeights_[facei])
        {
            fault.set(facei);
        }
    }

    const scalarField sinesNow(sines(wrap));
    forAll(sinesNow, p)
    {
        if (sinesNow[p] < leastSines_[p])
        {
            fault.set(addressing_.pointFaces[p]);
        }
    }

    return fault.sortedToc();
}


// * * * * * * * * * * * * * *  Snap To Surface  * * * * * * * * * * * * * * //

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
    snapping reduced(const label p) const
    {
        switch (snapping_[p])
        {
            case snapping::full:
                return targets_.hasEdge(p)
                  ? snapping::toFace : snapping::halfWay;

            case snapping::toFace:
                return snapping::halfWay;

            default:
                return snapping::none;
        }
    }

    //- Points of faces at fault: those of side patches only where faces
    //  intersect, and of a face only those that go to sharp edges, if it has
    //  any and they are first
    bitSet pointsAtFault(const bool edgesFirst) const
    {
        bitSet all(snapping_.size());
        const auto add = [&](const labelList& faces, const bitSet& but)
        {
            for (const label facei : faces)
            {
                const face& f = wrap_.faces[facei];
                const bool onlyOnEdges = edgesFirst
                 && anyOf(f, [&](const label p) { return isOnEdge(p); });

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

    //- Hold points back until no faces are at fault
    void holdBack()
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

    //- Points held back that were not tried again, never two of one face
    labelList heldBackApart(bitSet& tried) const
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

    //- Snap points fully, except those that then are of faces at fault;
    //  whether any point stays snapped
    bool snapFully(const labelList& points)
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

    //- Try points again that were held back because of others
    void tryAgain()
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

    snapCounts snap()
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
};

} // End anonymous namespace


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
