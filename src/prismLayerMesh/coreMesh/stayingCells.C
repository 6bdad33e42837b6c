/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stayingCells.H"
#include "bitSet.H"
#include "boundBox.H"
#include "edgeHashes.H"
#include "HashSet.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

corePlanes::corePlanes
(
    const polyMeshParts& core,
    const UList<sidePatch>& planes
)
:
    core_(core),
    planes_(planes),
    tolerance_(1e-9*boundBox(core.points, false).mag())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label corePlanes::planeOf(const label facei) const
{
    forAll(planes_, s)
    {
        bool isInside = true;
        for (const label p : core_.topology.faces[facei])
        {
            isInside = isInside && isIn(s, p);
        }
        if (isInside)
        {
            return s;
        }
    }

    return -1;
}


bitSet corePlanes::pointsIn(const label plane) const
{
    bitSet points(core_.points.size());
    forAll(core_.points, p)
    {
        points.set(p, isIn(plane, p));
    }

    return points;
}


labelList corePlanes::facesTouching
(
    const label plane,
    const std::function<bool(label)>& stays
) const
{
    const polyMeshTopology& t = core_.topology;
    const bitSet isInPlane(pointsIn(plane));
    labelHashSet points;
    edgeHashSet edges;
    for (label i = t.neighbour.size(); i < t.faces.size(); ++i)
    {
        if (stays(t.owner[i]) && planeOf(i) == plane)
        {
            points.insert(t.faces[i]);
            edges.insert(t.faces[i].edges());
        }
    }

    // The plane is triangulated beside these faces alone
    const auto isBeside = [&](const edge& e)
    {
        return points.found(e.start())
         && (!isInPlane.test(e.end()) || edges.found(e));
    };

    DynamicList<label> touching;
    forAll(t.faces, facei)
    {
        const face& f = t.faces[facei];
        bool touches = false;
        forAll(f, k)
        {
            touches = touches
             || (
                    isInPlane.test(f[k])
                 && !isBeside(edge(f[k], f.nextLabel(k)))
                );
        }

        if (touches)
        {
            touching.append(facei);
        }
    }

    return labelList(std::move(touching));
}


// * * * * * * * * * * * * * * *  Staying Cells  * * * * * * * * * * * * * * //

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
            if (t.beyond(facei) >= 0)
            {
                boxes_[t.beyond(facei)].add(core_.points[p]);
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


bool stayingCells::removeWithImages(const labelPair& cyclicPatches)
{
    const polyMeshTopology& t = core_.topology;
    const label first = t.patchStarts[cyclicPatches.first()];
    const label second = t.patchStarts[cyclicPatches.second()];
    bool more = false;
    for (label i = 0; i < t.patchSizes[cyclicPatches.first()]; ++i)
    {
        const label a = t.owner[first + i];
        const label b = t.owner[second + i];
        if ((*this)[a] != (*this)[b])
        {
            leave(a);
            leave(b);
            more = true;
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
    const UList<sidePatch>& planes,
    const UList<labelPair>& cyclicPatches
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
    bool more = true;
    while (more)
    {
        more = false;
        for (label plane = 0; plane < planes_.size(); ++plane)
        {
            more = removeTouching(plane) || more;
        }
        for (const labelPair& pair : cyclicPatches)
        {
            more = removeWithImages(pair) || more;
        }
        if (more)
        {
            removeWide();
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


// * * * * * * * * * * * * * *  Patches On Wall  * * * * * * * * * * * * * * //

namespace
{

//- Constants that were tuned
const struct
{
    //- Faces of a patch on the wall are nearer to the obstacles than so many
    //  widths of their cells
    scalar onWall = 2;

    //- Cosine of the angle between the normal of one of them and the way to the
    //  obstacles, at least: all faces on a side of the domain look away
    scalar towardsWall = 0.1;

    //- Where the owner of a face begins: share of the way to its centre
    scalar within = 0.1;

} tunedPatches;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool stayingCells::looksAtObstacles(const label facei) const
{
    const face& f = core_.topology.faces[facei];
    const vector fromFoot
    (
        obstacles_.surface.footOf(f.centre(core_.points)).direction
    );

    return (-fromFoot & f.unitNormal(core_.points)) > tunedPatches.towardsWall;
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
                centre, tunedPatches.onWall*width(t.owner[facei])
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
            names.append(core_.patches.names[patchi]);
            for (const label i : core_.topology.patchFaces(patchi))
            {
                leave(core_.topology.owner[i]);
            }
        }
    }

    wallPatches_.transfer(names);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool stayingCells::isPlain(const label patchi) const
{
    const wordList plain({"patch", "wall", "symmetry", "symmetryPlane"});

    return plain.found(core_.patches.entries[patchi].get<word>("type"));
}


bool stayingCells::inFluid(const label facei) const
{
    const label own = core_.topology.owner[facei];
    const point centre(core_.topology.faces[facei].centre(core_.points));
    const vector inwards(boxes_[own].midpoint() - centre);

    // Not through layers that are near to the face
    const scalar room = 0.5*obstacles_.surface.footOf(centre).distance;
    const scalar within =
        min(tunedPatches.within, room/max(mag(inwards), VSMALL));

    return obstacles_.fluid.inFront(centre + within*inwards);
}


// * * * * * * * * * * * * * *  Coupled Patches  * * * * * * * * * * * * * * //

//- Number of the faces of a patch whose cells stay
static label nStaying
(
    const polyMeshParts& core,
    const stayingCells& stays,
    const label patchi
)
{
    label n = 0;
    for (const label facei : core.topology.patchFaces(patchi))
    {
        n += stays[core.topology.owner[facei]];
    }

    return n;
}


void refuseCoupled
(
    const polyMeshParts& core,
    const stayingCells& stays,
    const coreObstacles& obstacles,
    const label patchi
)
{
    const polyMeshTopology& t = core.topology;
    const dictionary& entry = core.patches.entries[patchi];
    const word neighbour(entry.lookupOrDefault<word>("neighbourPatch", ""));
    const label other = core.patches.names.find(neighbour);

    // Both of a pair may be behind the obstacles
    const bool isGone =
        !nStaying(core, stays, patchi)
     && (other < 0 || !nStaying(core, stays, other));

    for (const label facei : t.patchFaces(patchi))
    {
        if (stays[t.owner[facei]] || (isGone && !stays.inFluid(facei)))
        {
            continue;
        }

        const point centre(t.faces[facei].centre(core.points));
        FatalErrorInFunction
            << "The layers need room at the patch "
            << core.patches.names[patchi] << " of type "
            << entry.get<word>("type") << ", at " << centre << ", "
            << obstacles.surface.footOf(centre).distance << " from them" << nl
            << "Make the cells between the patch and the layers smaller, or"
            << " farField.gap, or move the patch away" << exit(FatalError);
    }
}

} // End namespace Foam

// ************************************************************************* //
