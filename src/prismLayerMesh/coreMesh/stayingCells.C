/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stayingCells.H"
#include "bitSet.H"

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

} tunedCells;

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
        const scalar length = tunedCells.longEdge
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


void stayingCells::removeWide()
{
    removeBeside([&](const label a, const label b)
    {
        return width(a) > tunedCells.wider*width(b);
    });
}


bool stayingCells::removeTouching(const label plane)
{
    const labelList faces
    (
        planes_.facesTouching
        (
            plane, [&](const label celli) { return (*this)[celli]; }
        )
    );

    bool more = false;
    const auto remove = [&](const label celli)
    {
        more = more || (*this)[celli];
        leave(celli);
    };
    for (const label facei : faces)
    {
        remove(core_.topology.owner[facei]);
        if (facei < nInternal_)
        {
            remove(core_.topology.neighbour[facei]);
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
    planes_(core, planes),
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

} // End namespace Foam

// ************************************************************************* //
