/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stayingCells.H"
#include "bitSet.H"
#include "edgeHashes.H"
#include "HashSet.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Constants that were tuned
const struct
{
    //- A cell is wider than another if it is by more than this factor
    scalar wider = 1.5;

    //- The gap is in widths of cells, or in such shares of edges
    scalar longEdge = 0.5;

    //- Faces of a patch on the wall are nearer to the obstacles than so many
    //  widths of their cells
    scalar onWall = 2;

    //- Cosine of the angle between the normal of one of them and the way to the
    //  obstacles, at least: all faces on a side of the domain look away
    scalar towardsWall = 0.1;

    //- Where the owner of a face begins: share of the way to its centre
    scalar within = 0.1;

} tuned;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void stayingCells::setBoxes()
{
    const polyMeshTopology& t = core_.topology;

    forAll(t.faces, facei)
    {
        for (const label p : t.faces[facei])
        {
            boxes_[t.owner[facei]].add(core_.points[p]);
            if (facei < nInternal_)
            {
                boxes_[t.neighbour[facei]].add(core_.points[p]);
            }
        }
    }
}


bool stayingCells::isNear(const label celli, const scalar length) const
{
    const vector margin(vector::uniform(gap_*length));
    const boundBox& box = boxes_[celli];

    return obstacles_.surface.overlaps
    (
        boundBox(box.min() - margin, box.max() + margin)
    );
}


void stayingCells::removeNear()
{
    #pragma omp parallel for schedule(dynamic, 1024)
    forAll(states_, celli)
    {
        if (isNear(celli, width(celli)))
        {
            states_[celli] = states::makesRoom;
        }
    }
}


void stayingCells::removeBeside(const neighbourGoes& goes)
{
    bool more = true;
    while (more)
    {
        more = false;
        for (label facei = 0; facei < nInternal_; ++facei)
        {
            label a = core_.topology.owner[facei];
            label b = core_.topology.neighbour[facei];
            if ((*this)[b])
            {
                std::swap(a, b);
            }

            if ((*this)[a] && !(*this)[b] && goes(a, b))
            {
                leave(a);
                more = true;
            }
        }
    }
}


void stayingCells::removeAtLongEdges()
{
    bitSet asked(core_.nCells);
    removeBeside([&](const label a, const label b)
    {
        if (!makesRoom(b) || !asked.set(a))
        {
            return false;
        }
        const scalar length = tuned.longEdge
           *obstacles_.surface.longestEdgeAt(boxes_[a].midpoint());

        return length > width(a) && isNear(a, length);
    });
}


void stayingCells::removeBehind()
{
    disjointSets together(parts());

    // Cells of a part follow the smallest
    forAll(states_, celli)
    {
        if ((*this)[celli])
        {
            const label first = together.find(celli);
            const bool isInFront = first == celli
              ? obstacles_.fluid.inFront(boxes_[celli].midpoint())
              : (*this)[first];
            states_[celli] = isInFront ? states::stays : states::isBehind;
        }
    }
}


bool stayingCells::looksAtObstacles(const label facei) const
{
    const face& f = core_.topology.faces[facei];
    const vector fromFoot
    (
        obstacles_.surface.footOf(f.centre(core_.points)).direction
    );

    return (-fromFoot & f.unitNormal(core_.points)) > tuned.towardsWall;
}


bool stayingCells::liesOnWall(const label patchi) const
{
    const polyMeshTopology& t = core_.topology;
    const label start = t.patchStarts[patchi];
    const label size = t.patchSizes[patchi];
    bool near = size > 0 && isPlain(patchi);
    label nBehind = 0;
    bool looksAtWall = false;

    for (label facei = start; near && facei < start + size; ++facei)
    {
        const point centre(t.faces[facei].centre(core_.points));
        if (planeOf(facei) >= 0)
        {
            near = false;
        }
        else if (!inFluid(facei))
        {
            ++nBehind;
        }
        else
        {
            near = obstacles_.surface.nearer
            (
                centre, tuned.onWall*width(t.owner[facei])
            );
            looksAtWall = looksAtWall || looksAtObstacles(facei);
        }
    }

    return near && (looksAtWall || 2*nBehind > size);
}


void stayingCells::removeOnWall()
{
    DynamicList<word> names;

    forAll(core_.patches.names, patchi)
    {
        if (liesOnWall(patchi))
        {
            const label start = core_.topology.patchStarts[patchi];
            const label size = core_.topology.patchSizes[patchi];
            names.append(core_.patches.names[patchi]);
            for (label i = start; i < start + size; ++i)
            {
                leave(core_.topology.owner[i]);
            }
        }
    }

    wallPatches_.transfer(names);
}


void stayingCells::removeWide()
{
    removeBeside([&](const label a, const label b)
    {
        return width(a) > tuned.wider*width(b);
    });
}


bool stayingCells::removeTouching(const label plane)
{
    const polyMeshTopology& t = core_.topology;
    bitSet isIn(core_.points.size());
    forAll(core_.points, p)
    {
        isIn.set(p, isInPlane(plane, p));
    }

    labelHashSet points;
    edgeHashSet edges;
    for (label facei = nInternal_; facei < t.faces.size(); ++facei)
    {
        if ((*this)[t.owner[facei]] && planeOf(facei) == plane)
        {
            points.insert(t.faces[facei]);
            edges.insert(t.faces[facei].edges());
        }
    }

    // The plane is triangulated beside these faces alone
    const auto isBeside = [&](const edge& e)
    {
        return points.found(e.start())
         && (!isIn.test(e.end()) || edges.found(e));
    };

    bool more = false;
    forAll(t.faces, facei)
    {
        const face& f = t.faces[facei];
        bool touches = false;
        forAll(f, k)
        {
            touches = touches
             || (isIn.test(f[k]) && !isBeside(edge(f[k], f.nextLabel(k))));
        }

        if (touches)
        {
            more = more || (*this)[t.owner[facei]];
            leave(t.owner[facei]);
            if (facei < nInternal_)
            {
                more = more || (*this)[t.neighbour[facei]];
                leave(t.neighbour[facei]);
            }
        }
    }

    return more;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

stayingCells::stayingCells
(
    const polyMeshParts& core,
    const coreObstacles& obstacles,
    const scalar gap,
    const UList<sidePatch>& planes
)
:
    core_(core),
    obstacles_(obstacles),
    gap_(gap),
    planes_(planes),
    tolerance_(1e-9*boundBox(core.points, false).mag()),
    nInternal_(core.topology.neighbour.size()),
    boxes_(core.nCells, boundBox(boundBox::invertedBox)),
    states_(core.nCells, states::stays)
{
    setBoxes();
    removeNear();
    removeBehind();
    removeAtLongEdges();
    removeOnWall();
    removeWide();
    for (label plane = 0; plane < planes_.size();)
    {
        if (removeTouching(plane))
        {
            removeWide();
            plane = 0;
        }
        else
        {
            ++plane;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

disjointSets stayingCells::parts() const
{
    disjointSets together(core_.nCells);
    for (label facei = 0; facei < nInternal_; ++facei)
    {
        const label own = core_.topology.owner[facei];
        const label nei = core_.topology.neighbour[facei];
        if ((*this)[own] && (*this)[nei])
        {
            together.join(own, nei);
        }
    }

    return together;
}


label stayingCells::planeOf(const label facei) const
{
    forAll(planes_, s)
    {
        bool isIn = true;
        for (const label p : core_.topology.faces[facei])
        {
            isIn = isIn && isInPlane(s, p);
        }
        if (isIn)
        {
            return s;
        }
    }

    return -1;
}


bool stayingCells::isPlain(const label patchi) const
{
    const wordList plain({"patch", "wall", "symmetry", "symmetryPlane"});

    return plain.found(core_.patches.entries[patchi].get<word>("type"));
}


bool stayingCells::inFluid(const label facei) const
{
    const label own = core_.topology.owner[facei];
    const point centre(core_.topology.faces[facei].centre(core_.points));

    return obstacles_.fluid.inFront
    (
        centre + tuned.within*(boxes_[own].midpoint() - centre)
    );
}

} // End namespace Foam

// ************************************************************************* //
