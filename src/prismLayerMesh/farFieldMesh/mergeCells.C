/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mergeCells.H"
#include "cellGain.H"
#include "bitSet.H"
#include "HashSet.H"
#include "ListOps.H"
#include "cellPredicates.H"
#include "unitConversion.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Layers below the outer surface whose cells take part in the gains
static const label nContextLayers = 3;


typedef DynamicList<label, 64> fewLabels;


//- Appends a label that is not in the list
static void appendNew(const label i, fewLabels& list)
{
    if (list.find(i) < 0)
    {
        list.append(i);
    }
}


//- A mesh whose cells merge: the far field, and the last layers below
class mergingMesh
{
    typedef DynamicList<label, 8> faceLabels;

    struct mergingFace
    {
        //- -1: beyond the boundary, or between parts of one cell
        label owner;
        label neighbour;
        vector area;
        point centre;

        //- Points of a triangle of the far field, in far.points; or -1
        label far = -1;
    };

    struct mergingCell
    {
        faceLabels faces;
        point centre = Zero;
        scalar volume = 0;

        //- Number of tetrahedra, 0 if the cell is none
        label nTets = 0;
    };

    const farFieldMesh& far_;
    DynamicList<mergingFace> faces_;
    List<mergingCell> cells_;

    //- The cell that each cell is part of
    labelList partOf_;

    void addFace(const mergingFace& f)
    {
        cells_[f.owner].faces.append(faces_.size());
        if (f.neighbour >= 0)
        {
            cells_[f.neighbour].faces.append(faces_.size());
        }
        faces_.append(f);
    }

    void addFace
    (
        const label owner,
        const label neighbour,
        const pointField& points
    )
    {
        const face f(identity(points.size()));
        addFace
        (
            mergingFace
            {
                owner, neighbour, f.areaNormal(points), f.centre(points), -1
            }
        );
    }

    void addFarFaces(const label nContext);
    void addLayerFaces
    (
        const prismLayers& layers,
        const wallAddressing& addressing,
        const label nContext
    );
    void setCentre(mergingCell& c, const label celli);

public:

    //- What a merge has changed
    struct change
    {
        label a;
        label b;
        mergingCell cellA;
        mergingCell cellB;
        DynamicList<std::pair<label, mergingFace>, 16> faces;
    };

    mergingMesh
    (
        const prismLayers& layers,
        const wallAddressing& addressing,
        const label nTets,
        const farFieldMesh& far
    );

    label nCells() const { return cells_.size(); }

    label nTets(const label c) const { return cells_[c].nTets; }

    label partOf(label c) const
    {
        while (partOf_[c] != c)
        {
            c = partOf_[c];
        }

        return c;
    }

    //- The explicit gain of a cell; seen is for work
    scalar gain(const label c, DynamicList<schemeFace>& seen) const;

    //- Whether the centre of a polyhedron is behind all faces, exactly
    bool isStar(const label c) const;

    //- Appends the cells across the faces of a cell that are not in the list
    void appendNeighbours(const label c, fewLabels& cells) const;

    //- Merges cell b into a
    change merge(const label a, const label b);

    void undo(const change& made);

    //- Sum of the excess of the faces of two cells beyond bounds
    scalar excessOfFaces
    (
        const label a,
        const label b,
        const mergeControls& controls
    ) const;
};


mergingMesh::mergingMesh
(
    const prismLayers& layers,
    const wallAddressing& addressing,
    const label nTets,
    const farFieldMesh& far
)
:
    far_(far)
{
    const label nContext = min(nContextLayers, layers.nLayers);
    cells_.setSize(far.nCells + nContext*layers.faces.size());
    partOf_ = identity(cells_.size());
    faces_.reserve(2*cells_.size() + far.topology.faces.size());
    addFarFaces(nContext);
    addLayerFaces(layers, addressing, nContext);
    forAll(cells_, c)
    {
        setCentre(cells_[c], c);
        cells_[c].nTets = c < nTets;
    }
}


void mergingMesh::addFarFaces(const label nContext)
{
    const polyMeshTopology& t = far_.topology;
    const label nInternal = t.neighbour.size();

    forAll(t.faces, f)
    {
        const label k = f - t.patchStarts[0];
        const label across =
            f < nInternal ? t.neighbour[f]
          : k < t.patchSizes[0] && nContext
          ? far_.nCells + nContext*far_.frontFaces[k] : -1;
        const face& points = t.faces[f];
        addFace
        (
            mergingFace
            {
                t.owner[f], across, points.areaNormal(far_.points),
                points.centre(far_.points), f
            }
        );
    }
}


void mergingMesh::addLayerFaces
(
    const prismLayers& layers,
    const wallAddressing& addressing,
    const label nContext
)
{
    const auto cellOf = [&](const label front, const label j)
    {
        return far_.nCells + nContext*front + j;
    };

    for (label j = 0; j < nContext; ++j)
    {
        const label high = layers.nLayers - j;
        forAll(layers.faces, front)
        {
            const face& f = layers.faces[front];
            pointField points(f.size());
            forAll(points, k)
            {
                points[k] = layers(f[f.size() - 1 - k], high - 1);
            }
            addFace
            (
                cellOf(front, j), j + 1 < nContext ? cellOf(front, j + 1) : -1,
                points
            );
        }
        forAll(addressing.edges, e)
        {
            const labelPair& fronts = addressing.edgeFaces[e];
            const edge& ends = addressing.edges[e];
            const label direction =
                layers.faces[fronts.first()].edgeDirection(ends);
            const label a = direction > 0 ? ends.start() : ends.end();
            const label b = ends.otherVertex(a);
            addFace
            (
                cellOf(fronts.first(), j),
                fronts.second() < 0 ? -1 : cellOf(fronts.second(), j),
                pointField
                ({
                    layers(a, high - 1), layers(b, high - 1), layers(b, high),
                    layers(a, high)
                })
            );
        }
    }
}


//- As OpenFOAM: pyramids from the mean of the centres of the faces
void mergingMesh::setCentre(mergingCell& c, const label celli)
{
    point middle = Zero;
    for (const label f : c.faces)
    {
        middle += faces_[f].centre/c.faces.size();
    }

    for (const label f : c.faces)
    {
        const mergingFace& g = faces_[f];
        const scalar height = g.area & (g.centre - middle);
        const scalar volume = (g.owner == celli ? height : -height)/3;
        c.volume += volume;
        c.centre += volume*(0.75*g.centre + 0.25*middle);
    }
    c.centre = mag(c.volume) > VSMALL ? c.centre/c.volume : middle;
}


scalar mergingMesh::gain(const label c, DynamicList<schemeFace>& seen) const
{
    const point& own = cells_[c].centre;
    seen.clear();
    for (const label f : cells_[c].faces)
    {
        const mergingFace& g = faces_[f];
        const bool owns = g.owner == c;
        const label other = owns ? g.neighbour : g.owner;
        const vector area(owns ? g.area : -g.area);
        seen.append
        (
            seenFace
            (
                area, g.centre, own, other < 0 ? nullptr : &cells_[other].centre
            )
        );
    }

    return cellGain(seen, cells_[c].volume);
}


bool mergingMesh::isStar(const label c) const
{
    for (const label f : cells_[c].faces)
    {
        const face& points = far_.topology.faces[faces_[f].far];
        const int side = faces_[f].owner == c ? 1 : -1;

        for (label k = 1; k + 1 < points.size(); ++k)
        {
            // The normal of a face points away from its owner
            if
            (
                side*orientation
                (
                    far_.points[points[0]], far_.points[points[k]],
                    far_.points[points[k + 1]], cells_[c].centre
                ) >= 0
            )
            {
                return false;
            }
        }
    }

    return true;
}


void mergingMesh::appendNeighbours(const label c, fewLabels& cells) const
{
    for (const label f : cells_[c].faces)
    {
        if (faces_[f].neighbour >= 0)
        {
            appendNew
            (
                faces_[f].owner == c ? faces_[f].neighbour : faces_[f].owner,
                cells
            );
        }
    }
}


mergingMesh::change mergingMesh::merge(const label a, const label b)
{
    change made{a, b, cells_[a], cells_[b], {}};
    mergingCell& into = cells_[a];
    mergingCell& from = cells_[b];
    const scalar volume = into.volume + from.volume;
    into.centre = (into.volume*into.centre + from.volume*from.centre)/volume;
    into.volume = volume;
    into.nTets += from.nTets;

    into.faces.clear();
    for (const label f : made.cellA.faces)
    {
        if (faces_[f].owner != b && faces_[f].neighbour != b)
        {
            into.faces.append(f);
        }
    }
    for (const label f : from.faces)
    {
        mergingFace& g = faces_[f];
        if (g.owner == a || g.neighbour == a)
        {
            continue;
        }
        made.faces.append(std::make_pair(f, g));
        (g.owner == b ? g.owner : g.neighbour) = a;
        into.faces.append(f);
    }
    from.faces.clear();
    partOf_[b] = a;

    return made;
}


void mergingMesh::undo(const change& made)
{
    for (const auto& f : made.faces)
    {
        faces_[f.first] = f.second;
    }
    cells_[made.a] = made.cellA;
    cells_[made.b] = made.cellB;
    partOf_[made.b] = made.b;
}


scalar mergingMesh::excessOfFaces
(
    const label a,
    const label b,
    const mergeControls& controls
) const
{
    const scalar least = Foam::cos(degToRad(controls.maxNonOrtho));
    scalar sum = 0;
    const auto add = [&](const label f)
    {
        const mergingFace& g = faces_[f];
        if (g.neighbour < 0)
        {
            return;
        }
        const vector d(cells_[g.neighbour].centre - cells_[g.owner].centre);
        const scalar cosine = (g.area & d)/max(mag(g.area)*mag(d), VSMALL);
        const scalar toOwner =
            mag(g.area & (g.centre - cells_[g.owner].centre));
        const scalar toNeighbour =
            mag(g.area & (cells_[g.neighbour].centre - g.centre));
        const scalar weight =
            min(toOwner, toNeighbour)/max(toOwner + toNeighbour, VSMALL);
        sum += max(least - cosine, scalar(0))/least
          + max(controls.minWeight - weight, scalar(0))/controls.minWeight;
    };
    for (const label f : cells_[a].faces)
    {
        add(f);
    }
    for (const label f : cells_[b].faces)
    {
        if (faces_[f].owner != a && faces_[f].neighbour != a)
        {
            add(f);
        }
    }

    return sum;
}


//- Merges the tetrahedra around cells with large gains
class gainMerger
{
    mergingMesh& mesh_;
    const mergeControls& controls_;

    //- The gains now
    scalarField gains_;

    DynamicList<schemeFace> seen_;

    scalar excess(const scalar gain) const
    {
        return sqr(max(gain - controls_.gain, scalar(0)));
    }

    //- The cells with a gain that a merge of two cells changes
    fewLabels cellsAround(const labelPair& pair) const;

    //- The pairs of tetrahedra, or polyhedra of them, at a cell
    DynamicList<labelPair> pairsAt(const label c) const;

    //- Returns by how much the excess falls if a pair merges, 0 if it must not
    scalar dropOf(const labelPair& pair);

    //- Merges the best pair at a cell. Returns the cells around it; none if no
    //  pair may merge.
    fewLabels mergeAt(const label c);

public:

    gainMerger(mergingMesh& mesh, const mergeControls& controls);

    //- Merges at all cells with large gains
    void mergeAll();
};


gainMerger::gainMerger(mergingMesh& mesh, const mergeControls& controls)
:
    mesh_(mesh),
    controls_(controls),
    gains_(mesh.nCells())
{
    #pragma omp parallel
    {
        DynamicList<schemeFace> seen;

        #pragma omp for schedule(static)
        forAll(gains_, c)
        {
            gains_[c] = mesh_.gain(c, seen);
        }
    }
}


fewLabels gainMerger::cellsAround(const labelPair& pair) const
{
    fewLabels around;
    around.append(pair.first());
    around.append(pair.second());
    mesh_.appendNeighbours(pair.first(), around);
    mesh_.appendNeighbours(pair.second(), around);

    return around;
}


DynamicList<labelPair> gainMerger::pairsAt(const label c) const
{
    fewLabels starts;
    if (mesh_.nTets(c))
    {
        starts.append(c);
    }
    else
    {
        mesh_.appendNeighbours(c, starts);
    }

    DynamicList<labelPair> pairs;
    for (const label a : starts)
    {
        fewLabels others;
        mesh_.appendNeighbours(a, others);
        for (const label b : others)
        {
            if
            (
                mesh_.nTets(a) && mesh_.nTets(b)
             && mesh_.nTets(a) + mesh_.nTets(b) <= controls_.maxTets
             && (a < b || starts.find(b) < 0)
            )
            {
                pairs.append(labelPair(min(a, b), max(a, b)));
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());

    return pairs;
}


scalar gainMerger::dropOf(const labelPair& pair)
{
    const label a = pair.first();
    const fewLabels around(cellsAround(pair));
    scalar before = 0;
    scalar largest = 0;
    for (const label c : around)
    {
        before += excess(gains_[c]);
        largest = max(largest, gains_[c]);
    }
    const scalar faces = mesh_.excessOfFaces(a, pair.second(), controls_);

    const mergingMesh::change made(mesh_.merge(a, pair.second()));
    const scalar allowed = (1 - controls_.leastDrop)*before;
    bool better =
        mesh_.isStar(a) && mesh_.excessOfFaces(a, a, controls_) <= faces;
    scalar after = 0;
    for (label k = 0; better && k < around.size(); ++k)
    {
        if (around[k] != pair.second())
        {
            const scalar gain = mesh_.gain(around[k], seen_);
            after += excess(gain);
            better = gain <= largest && after < allowed;
        }
    }
    mesh_.undo(made);

    return better ? before - after : 0;
}


fewLabels gainMerger::mergeAt(const label c)
{
    labelPair best(-1, -1);
    scalar largest = 0;
    for (const labelPair& pair : pairsAt(c))
    {
        const scalar drop = dropOf(pair);
        if (drop > largest)
        {
            largest = drop;
            best = pair;
        }
    }

    fewLabels around;
    if (largest > 0)
    {
        mesh_.merge(best.first(), best.second());
        gains_[best.second()] = 0;
        around.append(best.first());
        mesh_.appendNeighbours(best.first(), around);
        for (const label r : around)
        {
            gains_[r] = mesh_.gain(r, seen_);
        }
    }

    return around;
}


void gainMerger::mergeAll()
{
    labelList wanted(identity(gains_.size()));
    while (wanted.size())
    {
        DynamicList<label> poor;
        for (const label c : wanted)
        {
            if (gains_[c] > controls_.gain)
            {
                poor.append(c);
            }
        }
        std::stable_sort
        (
            poor.begin(), poor.end(),
            [&](const label a, const label b) { return gains_[a] > gains_[b]; }
        );

        // Only around what has changed, more can change
        labelHashSet changed;
        for (const label c : poor)
        {
            fewLabels around;
            do
            {
                around = mergeAt(c);
                changed.insert(around);
            }
            while (around.size() && gains_[c] > controls_.gain);
        }
        wanted = changed.sortedToc();
    }
}


} // End anonymous namespace


//- Gives the cells and faces of a mesh whose cells are parts of cells new
//  labels
static void renumberCells(const labelUList& newCells, farFieldMesh& far)
{
    const polyMeshTopology old(far.topology);
    const label nInternal = old.neighbour.size();
    const auto cellsOf = [&](const label f)
    {
        return labelPair(newCells[old.owner[f]], newCells[old.neighbour[f]]);
    };

    DynamicList<label> kept(nInternal);
    for (label f = 0; f < nInternal; ++f)
    {
        const labelPair cells(cellsOf(f));
        if (cells.first() != cells.second())
        {
            kept.append(f);
        }
    }
    std::stable_sort(kept.begin(), kept.end(), [&](const label a, const label b)
    {
        labelPair x(cellsOf(a));
        labelPair y(cellsOf(b));
        x.sort();
        y.sort();

        return x.first() != y.first()
          ? x.first() < y.first() : x.second() < y.second();
    });

    labelList newFaces(old.faces.size(), -1);
    boolList flipped(old.faces.size(), false);
    polyMeshTopology& t = far.topology;
    t = polyMeshTopology();
    t.reserve(old.faces.size(), kept.size());
    for (const label f : kept)
    {
        labelPair cells(cellsOf(f));
        flipped[f] = cells.first() > cells.second();
        cells.sort();
        newFaces[f] = t.faces.size();
        t.append
        (
            flipped[f] ? old.faces[f].reverseFace() : face(old.faces[f]),
            cells.first(), cells.second()
        );
    }
    forAll(old.patchStarts, patchi)
    {
        t.startPatch();
        const label end = old.patchStarts[patchi] + old.patchSizes[patchi];
        for (label f = old.patchStarts[patchi]; f < end; ++f)
        {
            newFaces[f] = t.faces.size();
            t.append(face(old.faces[f]), newCells[old.owner[f]]);
        }
    }

    for (cellZoneParts& zone : far.cellZones)
    {
        labelHashSet cells;
        for (const label c : zone.cells)
        {
            cells.insert(newCells[c]);
        }
        zone.cells = cells.sortedToc();
    }
    for (faceZoneParts& zone : far.faceZones)
    {
        DynamicList<label> faces;
        DynamicList<bool> flips;
        forAll(zone.faces, k)
        {
            const label f = zone.faces[k];
            if (newFaces[f] >= 0)
            {
                faces.append(newFaces[f]);
                flips.append(zone.flips[k] != flipped[f]);
            }
        }
        zone.faces = faces;
        zone.flips = flips;
    }
}


//- Points inside of polyhedra go
static void dropUnusedPoints(farFieldMesh& far)
{
    bitSet used(far.points.size());
    for (const face& f : far.topology.faces)
    {
        used.set(f);
    }
    if (label(used.count()) == far.points.size())
    {
        return;
    }

    const labelList kept(used.sortedToc());
    const labelList newPoints(invert(far.points.size(), kept));
    for (face& f : far.topology.faces)
    {
        inplaceRenumber(newPoints, f);
    }
    far.points = pointField(far.points, kept);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void mergeCells
(
    const prismLayers& layers,
    const wallAddressing& frontAddressing,
    const label nTets,
    const mergeControls& controls,
    farFieldMesh& far
)
{
    mergingMesh mesh(layers, frontAddressing, nTets, far);
    gainMerger(mesh, controls).mergeAll();

    labelList newCells(far.nCells, -1);
    label nNew = 0;
    forAll(newCells, c)
    {
        const label root = mesh.partOf(c);
        if (newCells[root] < 0)
        {
            newCells[root] = nNew++;
        }
        newCells[c] = newCells[root];
    }
    renumberCells(newCells, far);
    far.nCells = nNew;
    dropUnusedPoints(far);
}

} // End namespace Foam

// ************************************************************************* //
