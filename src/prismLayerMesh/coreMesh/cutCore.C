/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutCore.H"
#include "bitSet.H"
#include "disjointSets.H"
#include "HashSet.H"
#include "planeOutlines.H"
#include "ranges.H"
#include "stayingCells.H"

namespace Foam
{

namespace
{

struct coreCutter
{
    const polyMeshParts& core;
    const coreObstacles& obstacles;
    const UList<sidePatch>& planes;
    const stayingCells& stays;
    const UList<labelPair>& cyclicPatches;

    //- Triangles of the surface of the cut, on points of the core, and their
    //  patches
    DynamicList<face> triangles{};
    DynamicList<label> patchIDs{};

    //- The core's face of each triangle
    DynamicList<label> faces{};

    planeOutlines outlines = planeOutlines(planes.size());

    label nInternal() const { return core.topology.neighbour.size(); }

    const face& faceOf(const label facei) const
    {
        return core.topology.faces[facei];
    }

    void addCells(coreCut& cut) const
    {
        disjointSets parts(stays.parts());
        DynamicList<label> cells;
        DynamicList<label> room;
        DynamicList<label> first;
        for (label celli = 0; celli < core.nCells; ++celli)
        {
            if (stays[celli])
            {
                cells.append(celli);
                if (parts.find(celli) == celli)
                {
                    first.append(celli);
                }
            }
            else if (stays.makesRoom(celli))
            {
                room.append(celli);
            }
        }

        cut.seeds = seedsOf(first);
        cut.cells.transfer(cells);
        cut.room.transfer(room);
    }

    pointField seedsOf(const labelUList& cells) const
    {
        pointField centres;
        scalarField volumes;
        setCentresAndVolumes(core, cells, centres, volumes);

        return centres;
    }

    void addPolygon(const label facei, const bool turned, const label patchi)
    {
        for (const face& f : splitPolygon(core.points, faceOf(facei)))
        {
            triangles.append(turned ? f.reverseFace() : f);
            patchIDs.append(patchi);
            faces.append(facei);
        }
    }

    //- Adds the images of the triangles from 'first' on. They are parts of a
    //  face of the core.
    void addImages
    (
        const label first,
        const label facei,
        const label image,
        const label patchi
    )
    {
        const face& f = faceOf(facei);
        const label end = triangles.size();
        for (label i = first; i < end; ++i)
        {
            face triangle(triangles[i].reverseFace());
            for (label& p : triangle)
            {
                p = faceOf(image)[(f.size() - f.find(p)) % f.size()];
            }
            triangles.append(triangle);
            patchIDs.append(patchi);
            faces.append(image);
        }
    }

    //- A face whose cell is gone, and its image
    void addBoundary(const label facei, const label patchi)
    {
        const label plane = stays.planeOf(facei);
        label other = -1;
        for (const labelPair& pair : cyclicPatches)
        {
            other = pair.first() == patchi ? pair.second() : other;
            if (plane < 0 && pair.second() == patchi)
            {
                return;
            }
        }

        if (plane >= 0)
        {
            outlines.addGone(plane, faceOf(facei));
        }
        else if (other >= 0)
        {
            addBoundaryOfPair(facei, labelPair(patchi, other));
        }
        else if (stays.inFluid(facei))
        {
            addPolygon(facei, true, patchi);
        }
    }

    //- A face on the first of two cyclic patches, and its image; the cells of
    //  both are gone
    void addBoundaryOfPair(const label facei, const labelPair& patches)
    {
        const labelList& starts = core.topology.patchStarts;
        const label image =
            facei - starts[patches.first()] + starts[patches.second()];
        const bool isIn = stays.inFluid(facei);
        if (isIn != stays.inFluid(image))
        {
            refuseCoupled(core, stays, obstacles, patches.first());
            refuseCoupled(core, stays, obstacles, patches.second());
        }
        if (isIn)
        {
            const label first = triangles.size();
            addPolygon(facei, true, patches.first());
            addImages(first, facei, image, patches.second());
        }
    }

    //- Whether a patch is one of a pair whose faces are images
    bool isOfPair(const label patchi) const
    {
        return anyOf(cyclicPatches, [&](const labelPair& pair)
        {
            return pair.found(patchi);
        });
    }

    void addPatches()
    {
        const polyMeshTopology& t = core.topology;

        forAll(t.patchStarts, patchi)
        {
            // Further patches without a name are behind the obstacles
            const bool isWall =
                patchi >= core.patches.names.size()
             || stays.wallPatches().found(core.patches.names[patchi]);
            if (!isWall && !stays.isPlain(patchi) && !isOfPair(patchi))
            {
                refuseCoupled(core, stays, obstacles, patchi);
            }
            for (const label facei : t.patchFaces(patchi))
            {
                if (isWall)
                {
                    outlines.addWall(faceOf(facei));
                }
                else if (!stays[t.owner[facei]])
                {
                    addBoundary(facei, patchi);
                }
                else if (planes.size() && stays.planeOf(facei) >= 0)
                {
                    outlines.addStaying(faceOf(facei));
                }
            }
        }

        forAll(planes, s)
        {
            if (outlines.isEmpty(s))
            {
                FatalErrorInFunction
                    << "The mesh around the layers has no faces at the layers"
                    << " on the plane of " << planes[s].name << ", through "
                    << planes[s].origin << nl
                    << "Make the mesh end in this plane, or move the side"
                    << " plane to a side of the mesh" << exit(FatalError);
            }
        }
    }

    void addCut(coreCut& cut)
    {
        const polyMeshTopology& t = core.topology;
        cut.nBoundary = triangles.size();
        cut.boundaryFaces = faces;

        for (label facei = 0; facei < nInternal(); ++facei)
        {
            const bool nei = stays[t.neighbour[facei]];
            if (stays[t.owner[facei]] != nei)
            {
                addPolygon(facei, nei, core.patches.names.size());
            }
        }

        const label n = faces.size() - cut.nBoundary;
        cut.cutFaces = SubList<label>(faces, n, cut.nBoundary);
        cut.cutCells.setSize(n);
        forAll(cut.cutFaces, i)
        {
            const label own = t.owner[cut.cutFaces[i]];
            cut.cutCells[i] = stays[own] ? own : t.neighbour[cut.cutFaces[i]];
        }

        DynamicList<boundBox> boxes;
        for (const label celli : labelHashSet(cut.cutCells).sortedToc())
        {
            boxes.append(stays.box(celli));
        }
        cut.cutBoxes.transfer(boxes);
    }

    void moveTriangles(coreCut& cut)
    {
        labelList own(core.points.size(), -1);
        DynamicList<label> used;
        const auto ownLabel = [&](const label p)
        {
            if (own[p] < 0)
            {
                own[p] = used.size();
                used.append(p);
            }
            return own[p];
        };

        for (face& f : triangles)
        {
            for (label& p : f)
            {
                p = ownLabel(p);
            }
        }

        outlines.set(cut.borders, cut.limits);
        for (List<edgeList>* edges : {&cut.borders, &cut.limits})
        {
            for (edgeList& ofPlane : *edges)
            {
                for (edge& e : ofPlane)
                {
                    e = edge(ownLabel(e.start()), ownLabel(e.end()));
                }
            }
        }

        cut.surface.points = pointField(core.points, used);
        cut.surface.faces.transfer(triangles);
        cut.surface.patchIDs.transfer(patchIDs);
        cut.points.transfer(used);
    }

    coreCut cut()
    {
        coreCut made;
        made.wallPatches = stays.wallPatches();
        addCells(made);

        if (made.cells.empty())
        {
            FatalErrorInFunction
                << "No cell of the mesh around the layers stays: each is too"
                << " near to them for farField.gap" << nl
                << "Refine the mesh near the wall, or reduce farField.gap"
                << exit(FatalError);
        }

        addPatches();
        addCut(made);
        moveTriangles(made);

        return made;
    }
};

} // End anonymous namespace


coreCut cutCore
(
    const polyMeshParts& core,
    const coreObstacles& obstacles,
    const scalar gap,
    const UList<sidePatch>& planes,
    const UList<labelPair>& cyclicPatches
)
{
    const stayingCells stays(core, obstacles, gap, planes, cyclicPatches);

    return coreCutter{core, obstacles, planes, stays, cyclicPatches}.cut();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

roomParts::roomParts(const polyMeshParts& core, const coreCut& cut)
:
    core_(core),
    room_(cut.room),
    parts_(core.nCells, -1)
{
    bitSet makesRoom(core.nCells);
    makesRoom.set(room_);
    const polyMeshTopology& t = core.topology;
    disjointSets together(core.nCells);
    forAll(t.neighbour, facei)
    {
        const label own = t.owner[facei];
        const label nei = t.neighbour[facei];
        if (makesRoom.test(own) && makesRoom.test(nei))
        {
            together.join(own, nei);
        }
    }

    for (const label celli : room_)
    {
        parts_[celli] = together.find(celli);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label roomParts::across(const label facei, const label celli) const
{
    const polyMeshTopology& t = core_.topology;

    return parts_
    [
        t.owner[facei] == celli ? t.neighbour[facei] : t.owner[facei]
    ];
}


label roomParts::nearest(const point& x) const
{
    pointField centres;
    scalarField volumes;
    setCentresAndVolumes(core_, room_, centres, volumes);

    return room_.empty() ? -1 : parts_[room_[findMin(magSqr(centres - x)())]];
}


labelHashSet roomParts::partsIn(const cellZoneParts& zone) const
{
    bitSet isIn(core_.nCells);
    isIn.set(zone.cells);
    labelHashSet parts;
    for (const label celli : room_)
    {
        parts.insert(parts_[celli]);
    }
    for (const label celli : room_)
    {
        if (!isIn.test(celli))
        {
            parts.erase(parts_[celli]);
        }
    }

    return parts;
}


label roomParts::nElsewhere(const cellZoneParts& zone) const
{
    const labelHashSet parts(partsIn(zone));

    return countOf(zone.cells, [&](const label celli)
    {
        return parts_[celli] >= 0 && !parts.found(parts_[celli]);
    });
}

} // End namespace Foam

// ************************************************************************* //
