/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mergeCells.H"
#include "HashSet.H"
#include "ListOps.H"
#include "meshBuilder.H"
#include "mergingMesh.H"
#include "surfacePart.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Merges the tetrahedra around poor cells
class gainMerger
{
    mergingMesh& mesh_;
    const mergeControls& controls_;

    //- Gains and scores now
    scalarField gains_;
    scalarField scores_;

    DynamicList<schemeFace> seen_;

    scalar excess(const scalar score) const
    {
        return sqr(max(score - controls_.gain, scalar(0)));
    }

    //- Some cells, and the cells across their faces
    fewLabels withNeighbours(const labelUList& cells) const;

    scalar largestScore(const labelUList& cells);


    //- How poor a cell is: the larger one of its gain and of a share of its
    //  gain by least squares
    scalar scoreOf
    (
        const scalar gain,
        const UList<schemeFace>& faces
    ) const
    {
        return max
        (
            gain, controls_.leastSquaresShare*leastSquaresGain(faces)
        );
    }

    scalar scoreAt(const label c)
    {
        const scalar gain = gainOf(mesh_, c, seen_);

        return scoreOf(gain, seen_);
    }

    //- Sets gain and score of a cell; 'seen' is for work
    void rate(const label c, DynamicList<schemeFace>& seen)
    {
        gains_[c] = gainOf(mesh_, c, seen);
        scores_[c] = scoreOf(gains_[c], seen);
    }

    //- The pairs of tetrahedra, or polyhedra of them, at a cell, ascending
    DynamicList<labelList> pairsAt(const label c) const;

    //- A tetrahedron, or a polyhedron, with each two cells beside it, ascending
    DynamicList<labelList> triplesAt(const label c) const;

    void mergeInto(const labelUList& group);

    //- Returns by how much the excess falls if a group merges, 0 if it must not
    scalar dropOf(const labelUList& group);

    //- The group with the largest drop; empty if none may merge
    labelList bestOf(const UList<labelList>& groups);

    //- Merges the best pair at a cell, or the best triple if no pair may merge:
    //  a flat tetrahedron goes with both cells of one of its sides. Returns the
    //  cells around; none if there is no such group.
    fewLabels mergeAt(const label c);

public:

    gainMerger(mergingMesh& mesh, const mergeControls& controls);

    //- Makes the triangles on a polygon of the outer surface one face of one
    //  polyhedron, unless that makes cells poorer. Its points are seen from the
    //  polyhedron.
    void mergeOnPolygon(const labelUList& triangles, const face& polygon);

    //- Merges at all poor cells
    void mergeAll();

    schemeGrade grade() const { return gradeOf(mesh_, gains_); }
};


gainMerger::gainMerger(mergingMesh& mesh, const mergeControls& controls)
:
    mesh_(mesh),
    controls_(controls),
    gains_(mesh.nCells(), 0),
    scores_(mesh.nCells(), 0)
{}


//- Tetrahedra on triangles of a polygon, and those between them around the
//  edges within it. Empty if other cells are between.
static labelList cellsOnPolygon
(
    const mergingMesh& mesh,
    const labelUList& triangles
)
{
    const faceList& faces = mesh.far().topology.faces;
    labelHashSet cells;
    forAll(triangles, i)
    {
        for (const edge& e : faces[triangles[i]].edges())
        {
            for (label j = i + 1; j < triangles.size(); ++j)
            {
                if (faces[triangles[j]].edgeDirection(e) == 0)
                {
                    continue;
                }
                const labelList fan
                (
                    mesh.fanOf(e, triangles[i], triangles[j])
                );
                if (fan.empty())
                {
                    return labelList();
                }
                cells.insert(fan);
            }
        }
    }

    return cells.sortedToc();
}


void gainMerger::mergeOnPolygon
(
    const labelUList& triangles,
    const face& polygon
)
{
    const labelList cells(cellsOnPolygon(mesh_, triangles));
    if (cells.empty() || cells.size() > controls_.maxTets)
    {
        return;
    }
    const label stack = mesh_.neighbour(triangles[0]);
    fewLabels changed(cells);
    changed.append(stack);
    const fewLabels around(withNeighbours(changed));
    const scalar before = largestScore(around);

    const mergingMesh::state state(mesh_.stateOf(changed));
    mergeInto(cells);
    mesh_.unite(triangles, polygon);

    fewLabels left;
    for (const label c : around)
    {
        if (mesh_.partOf(c) == c)
        {
            left.append(c);
        }
    }
    if
    (
        !mesh_.isStar(cells[0])
     || !mesh_.isBehindPolygon(cells[0], triangles[0])
     || largestScore(left) > max(before, controls_.gain)
    )
    {
        mesh_.separate(triangles);
        mesh_.restore(state);
    }
}


fewLabels gainMerger::withNeighbours(const labelUList& cells) const
{
    fewLabels around;
    around.append(cells);
    for (const label c : cells)
    {
        mesh_.appendNeighbours(c, around);
    }

    return around;
}


scalar gainMerger::largestScore(const labelUList& cells)
{
    scalar largest = 0;
    for (const label c : cells)
    {
        largest = max(largest, scoreAt(c));
    }

    return largest;
}


DynamicList<labelList> gainMerger::pairsAt(const label c) const
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

    DynamicList<labelList> pairs;
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
                pairs.append(labelList({min(a, b), max(a, b)}));
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());

    return pairs;
}


DynamicList<labelList> gainMerger::triplesAt(const label c) const
{
    fewLabels others;
    mesh_.appendNeighbours(c, others);
    const auto n = [&](const label i) { return mesh_.nTets(others[i]); };
    DynamicList<labelList> triples;
    forAll(others, i)
    {
        for (label j = 0; j < i; ++j)
        {
            if
            (
                n(i) && n(j)
             && mesh_.nTets(c) + n(i) + n(j) <= controls_.maxTets
            )
            {
                labelList cells({c, others[i], others[j]});
                Foam::sort(cells);
                triples.append(cells);
            }
        }
    }

    return triples;
}


void gainMerger::mergeInto(const labelUList& group)
{
    for (label k = 1; k < group.size(); ++k)
    {
        mesh_.merge(group[0], group[k]);
    }
}


scalar gainMerger::dropOf(const labelUList& group)
{
    const label a = group[0];
    const fewLabels around(withNeighbours(group));
    scalar before = 0;
    scalar largest = 0;
    for (const label c : around)
    {
        before += excess(scores_[c]);
        largest = max(largest, scores_[c]);
    }
    before += mesh_.excessOfFaces(group, controls_);

    const mergingMesh::state state(mesh_.stateOf(group));
    mergeInto(group);
    const scalar allowed = (1 - controls_.leastDrop)*before;
    scalar after = mesh_.excessOfFaces(labelList(1, a), controls_);
    bool better = after < allowed && mesh_.isStar(a);
    for (label k = 0; better && k < around.size(); ++k)
    {
        if (around[k] == a || group.find(around[k]) < 0)
        {
            const scalar score = scoreAt(around[k]);
            after += excess(score);
            better = score <= largest && after < allowed;
        }
    }
    mesh_.restore(state);

    return better ? before - after : 0;
}


labelList gainMerger::bestOf(const UList<labelList>& groups)
{
    labelList best;
    scalar largest = 0;
    for (const labelList& group : groups)
    {
        const scalar drop = dropOf(group);
        if (drop > largest)
        {
            largest = drop;
            best = group;
        }
    }

    return best;
}


fewLabels gainMerger::mergeAt(const label c)
{
    labelList best(bestOf(pairsAt(c)));
    if (best.empty() && mesh_.nTets(c))
    {
        best = bestOf(triplesAt(c));
    }

    fewLabels around;
    if (best.size())
    {
        mergeInto(best);
        for (label k = 1; k < best.size(); ++k)
        {
            scores_[best[k]] = gains_[best[k]] = 0;
        }
        around.append(best[0]);
        mesh_.appendNeighbours(best[0], around);
        for (const label r : around)
        {
            rate(r, seen_);
        }
    }

    return around;
}


void gainMerger::mergeAll()
{
    #pragma omp parallel
    {
        DynamicList<schemeFace> seen;

        #pragma omp for schedule(static)
        forAll(scores_, c)
        {
            if (mesh_.partOf(c) == c)
            {
                rate(c, seen);
            }
        }
    }

    labelList wanted(identity(scores_.size()));
    while (wanted.size())
    {
        DynamicList<label> poor;
        for (const label c : wanted)
        {
            if (scores_[c] > controls_.gain)
            {
                poor.append(c);
            }
        }
        std::stable_sort
        (
            poor.begin(), poor.end(),
            [&](label a, label b) { return scores_[a] > scores_[b]; }
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
            while (around.size() && scores_[c] > controls_.gain);
        }
        wanted = changed.sortedToc();
    }
}

} // End anonymous namespace


//- Keeps polygons of the outer surface whole
static void mergeOnPolygons
(
    const prismLayers& layers,
    const farFieldMesh& far,
    gainMerger& merger
)
{
    const label start = far.topology.patchStarts[0];
    const label n = far.frontFaces.size();
    for (label k = 0, next = 0; k < n; k = next)
    {
        const label front = far.frontFaces[k];
        while (next < n && far.frontFaces[next] == front)
        {
            ++next;
        }
        if (next - k > 1)
        {
            merger.mergeOnPolygon
            (
                identity(next - k, start + k),
                layers.faces[front].reverseFace()
            );
        }
    }
}


//- The new cell of each cell of the far field. Returns the number of new ones.
static label numberCells(const mergingMesh& mesh, labelList& newCells)
{
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

    return nNew;
}


static void updateZones
(
    const labelList& newCells,
    const meshBuilder& faces,
    const labelList& newFaces,
    farFieldMesh& far
)
{
    for (cellZoneParts& zone : far.cellZones)
    {
        bitSet cells(far.nCells);
        for (const label c : zone.cells)
        {
            cells.set(newCells[c]);
        }
        zone.cells = cells.sortedToc();
    }
    for (faceZoneParts& zone : far.faceZones)
    {
        label n = 0;
        forAll(zone.faces, k)
        {
            const label f = zone.faces[k];
            if (newFaces[f] >= 0)
            {
                zone.flips[n] = zone.flips[k] != faces.isTurned(f);
                zone.faces[n++] = newFaces[f];
            }
        }
        zone.faces.setSize(n);
        zone.flips.setSize(n);
    }
}


//- Sets faces and zones of a far field whose cells have merged
static void setMergedFaces
(
    const mergingMesh& mesh,
    const labelList& newCells,
    const label nNewCells,
    farFieldMesh& far
)
{
    const polyMeshTopology& t = far.topology;
    const label nPatches = t.patchSizes.size();
    meshBuilder faces;
    forAll(t.neighbour, f)
    {
        faces.append
        (
            t.faces[f], newCells[t.owner[f]], newCells[t.neighbour[f]]
        );
    }
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        for (const label f : t.patchFaces(patchi))
        {
            const auto polygon = mesh.polygons().cfind(f);
            faces.append
            (
                polygon.good() ? *polygon : t.faces[f], newCells[t.owner[f]],
                meshBuilder::onPatch(patchi)
            );
            if (mesh.gone().test(f))
            {
                faces.leaveOut(f);
            }
        }
    }
    const labelList order(faces.order(nNewCells, nPatches));
    const labelList newFaces(invert(faces.size(), order));
    updateZones(newCells, faces, newFaces, far);
    DynamicList<label> fronts;
    forAll(far.frontFaces, k)
    {
        if (newFaces[t.patchStarts[0] + k] >= 0)
        {
            fronts.append(far.frontFaces[k]);
        }
    }
    far.frontFaces = fronts;
    far.topology = faces.topology(order, nPatches);

    // Points inside of polyhedra go
    removeUnusedPoints(far.topology.faces, far.points);
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
    gainMerger merger(mesh, controls);
    mergeOnPolygons(layers, far, merger);
    merger.mergeAll();
    far.grade = merger.grade();

    labelList newCells(far.nCells, -1);
    const label nNew = numberCells(mesh, newCells);
    setMergedFaces(mesh, newCells, nNew, far);
    far.nCells = nNew;
}

} // End namespace Foam

// ************************************************************************* //
