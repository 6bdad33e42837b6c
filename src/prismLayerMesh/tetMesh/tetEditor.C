/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetEditor.H"
#include "boolList.H"
#include "error.H"

#include <algorithm>
#include <array>
#include <cstdint>
#include <omp.h>

namespace Foam
{

namespace
{

//- Sorts items by a first point, which makes buckets of a few items each, and
//  by the rest of their points
template<class Rest>
class pointBuckets
{
    typedef std::pair<Rest, label> keyed;

    labelList starts_;
    List<keyed> keys_;

    //- Sets the start of each bucket from the numbers of items of each point in
    //  each part of the list, and turns these into places of the items
    void setStarts(List<labelList>& counts)
    {
        label sum = 0;
        forAll(starts_, p)
        {
            starts_[p] = sum;
            for (labelList& ofPart : counts)
            {
                const label n = ofPart[p];
                ofPart[p] = sum;
                sum += n;
            }
        }
    }

public:

    //- Sorts n items into buckets by their first points.
    //  keyOf(i): returns the first point of item i, and the rest of its points
    template<class KeyOf>
    pointBuckets(const label nPoints, const label n, const KeyOf& keyOf)
    :
        starts_(nPoints + 1),
        keys_(n)
    {
        // A part of the list for each thread
        const label nParts = omp_get_max_threads();
        List<labelList> counts(nParts);
        const auto visitPart = [&](const label part, const auto& visit)
        {
            const label end = std::int64_t(n)*(part + 1)/nParts;
            for (label i = std::int64_t(n)*part/nParts; i < end; ++i)
            {
                visit(i, keyOf(i));
            }
        };

        #pragma omp parallel for schedule(static, 1)
        for (label part = 0; part < nParts; ++part)
        {
            labelList& ofPart = counts[part];
            ofPart.setSize(nPoints + 1, 0);
            visitPart(part, [&](label, const std::pair<label, Rest>& key)
            {
                ++ofPart[key.first];
            });
        }
        setStarts(counts);

        #pragma omp parallel for schedule(static, 1)
        for (label part = 0; part < nParts; ++part)
        {
            labelList& places = counts[part];
            visitPart(part, [&](label i, const std::pair<label, Rest>& key)
            {
                keys_[places[key.first]++] = keyed(key.second, i);
            });
        }

        #pragma omp parallel for schedule(dynamic, 1024)
        for (label p = 0; p < nPoints; ++p)
        {
            std::sort
            (
                keys_.begin() + starts_[p], keys_.begin() + starts_[p + 1]
            );
        }
    }

    //- Calls visit(rest, i, isNew) for the items of a point in their order;
    //  isNew is false if the last one was equal
    template<class Visit>
    void visit(const label p, const Visit& visit) const
    {
        for (label k = starts_[p]; k < starts_[p + 1]; ++k)
        {
            const bool isNew =
                k == starts_[p] || keys_[k].first != keys_[k - 1].first;
            visit(keys_[k].first, keys_[k].second, isNew);
        }
    }
};

} // End anonymous namespace


List<FixedList<label, 4>> tetNeighbours
(
    const tetCellList& tets,
    const label nPoints
)
{
    typedef std::array<label, 2> twoPoints;

    const pointBuckets<twoPoints> buckets
    (
        nPoints, 4*tets.size(),
        [&](const label k)
        {
            const tetCell& tet = tets[k/4];
            label f[3] = {tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]};
            std::sort(f, f + 3);
            return std::make_pair(f[0], twoPoints{f[1], f[2]});
        }
    );
    List<FixedList<label, 4>> neighbours(tets.size(), FixedList<label, 4>(-1));

    #pragma omp parallel for schedule(dynamic, 1024)
    for (label p = 0; p < nPoints; ++p)
    {
        label last = -1;

        buckets.visit
        (
            p,
            [&](const twoPoints&, const label k, const bool isNew)
            {
                if (!isNew)
                {
                    neighbours[k/4][k % 4] = last/4;
                    neighbours[last/4][last % 4] = k/4;
                }
                last = k;
            }
        );
    }

    return neighbours;
}


void setTetEdges
(
    const tetCellList& tets,
    const label nPoints,
    edgeList& edges,
    List<FixedList<label, 6>>& tetEdges
)
{
    static const label ends[6][2] =
        {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

    const pointBuckets<label> buckets
    (
        nPoints, 6*tets.size(),
        [&](const label k)
        {
            const label p = tets[k/6][ends[k % 6][0]];
            const label q = tets[k/6][ends[k % 6][1]];
            return std::make_pair(min(p, q), max(p, q));
        }
    );
    DynamicList<edge> found(2*tets.size());
    tetEdges.setSize(tets.size());

    for (label p = 0; p < nPoints; ++p)
    {
        buckets.visit
        (
            p,
            [&](const label q, const label k, const bool isNew)
            {
                if (isNew)
                {
                    found.append(edge(p, q));
                }
                tetEdges[k/6][k % 6] = found.size() - 1;
            }
        );
    }

    edges.transfer(found);
}


// * * * * * * * * * * * * * * *  Split Tets * * * * * * * * * * * * * * * * //

//- Returns for each simplex its position in the order in which tetrahedra are
//  split: the shortest edges first, then the faces
static labelList splitOrder
(
    const simplexSet& simplices,
    const pointField& points
)
{
    scalarField lengths(simplices.simplices().size(), GREAT);
    forAll(lengths, i)
    {
        const simplex& s = simplices.simplices()[i];

        if (s[0] < 0)
        {
            lengths[i] = magSqr(points[s[2]] - points[s[1]]);
        }
    }

    return invert(lengths.size(), sortedOrder(lengths));
}


//- Returns the edge or face of a tetrahedron at which it is split first, as its
//  position in the set, or -1. inSet marks the points of the set.
static label firstSimplex
(
    const simplexSet& simplices,
    const labelUList& order,
    const boolList& inSet,
    const tetCell& tet
)
{
    DynamicList<label, 4> p;
    for (const label q : tet)
    {
        if (q < inSet.size() && inSet[q])
        {
            p.append(q);
        }
    }

    label first = -1;
    const auto look = [&](const simplex& s)
    {
        const label i = simplices.find(s);
        first = i >= 0 && (first < 0 || order[i] < order[first]) ? i : first;
    };

    for (label i = 0; i < p.size(); ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            look(sortedSimplex(-1, p[i], p[j]));

            for (label k = 0; k < j; ++k)
            {
                look(sortedSimplex(p[i], p[j], p[k]));
            }
        }
    }

    return first;
}


//- Split a tetrahedron at its first simplex, and the parts at theirs. The order
//  of the simplices is the same for all tetrahedra, so a face is split in the
//  same way from both sides.
static void split
(
    const simplexSet& simplices,
    const labelUList& order,
    const boolList& inSet,
    const label firstNewPoint,
    const tetCell& tet,
    DynamicList<tetCell>& parts
)
{
    const label first = firstSimplex(simplices, order, inSet, tet);

    if (first < 0)
    {
        parts.append(tet);
        return;
    }

    DynamicList<tetCell, 4> own;
    appendParts(tet, simplices.simplices()[first], firstNewPoint + first, own);

    for (const tetCell& part : own)
    {
        split(simplices, order, inSet, firstNewPoint, part, parts);
    }
}


point centreOf(const simplex& s, const pointField& points)
{
    point sum(Zero);
    label n = 0;

    for (const label p : s)
    {
        if (p >= 0)
        {
            sum += points[p];
            ++n;
        }
    }

    return sum/n;
}


void splitTets
(
    const simplexSet& simplices,
    const pointField& points,
    const label firstNewPoint,
    tetCellList& tets
)
{
    const labelList order(splitOrder(simplices, points));
    boolList inSet(firstNewPoint, false);
    for (const simplex& s : simplices.simplices())
    {
        for (const label p : s)
        {
            if (p >= 0)
            {
                inSet[p] = true;
            }
        }
    }

    DynamicList<tetCell> parts(tets.size());
    for (const tetCell& tet : tets)
    {
        split(simplices, order, inSet, firstNewPoint, tet, parts);
    }
    tets.transfer(parts);
}


// * * * * * * * * * * * * * * *  Tet Editor * * * * * * * * * * * * * * * * //

//- Whether the order of the points p q r s of a tetrahedron is an even
//  permutation of its own
static bool isAlike(const tetCell& tet, const FixedList<label, 4>& points)
{
    bool even = true;

    for (label i = 0; i < 4; ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            if (tet.find(points[j]) > tet.find(points[i]))
            {
                even = !even;
            }
        }
    }

    return even;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void tetEditor::connect
(
    const labelUList& tets,
    const UList<triFace>& outerFaces,
    const labelUList& outerTets
)
{
    // Faces that still look for their neighbours
    DynamicList<triFace, 64> faces(outerFaces);
    DynamicList<label, 64> neighbours(outerTets);
    for (const label t : tets)
    {
        for (label i = 0; i < 4; ++i)
        {
            const triFace f(tets_[t].face(i));
            label k = 0;

            while (k < faces.size() && !triFace::compare(faces[k], f))
            {
                ++k;
            }

            if (k == faces.size())
            {
                faces.append(f);
                neighbours.append(t);
                continue;
            }

            const label other = neighbours[k];
            neighbours_[t][i] = other;

            for (label j = 0; other >= 0 && j < 4; ++j)
            {
                if (triFace::compare(triFace(tets_[other].face(j)), f))
                {
                    neighbours_[other][j] = t;
                }
            }

            faces[k] = faces.last();
            neighbours[k] = neighbours.last();
            faces.remove();
            neighbours.remove();
        }
    }

    if (faces.size())
    {
        FatalErrorInFunction
            << "Tetrahedra that replace others have other faces: "
            << faces[0] << abort(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

tetEditor::tetEditor(const tetCellList& tets, const label nPoints)
:
    tets_(tets),
    neighbours_(tetNeighbours(tets, nPoints)),
    pointTet_(nPoints, -1)
{
    forAll(tets_, t)
    {
        for (const label p : tets_[t])
        {
            pointTet_[p] = t;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

DynamicList<label> tetEditor::star(const label p) const
{
    DynamicList<label> found(32);
    if (pointTet_[p] >= 0)
    {
        found.append(pointTet_[p]);
    }
    for (label k = 0; k < found.size(); ++k)
    {
        const label t = found[k];
        for (label i = 0; i < 4; ++i)
        {
            const label next = neighbours_[t][i];
            if (next >= 0 && tets_[t][i] != p && found.find(next) < 0)
            {
                found.append(next);
            }
        }
    }

    return found;
}


label tetEditor::addPoint()
{
    pointTet_.append(-1);

    return pointTet_.size() - 1;
}


void tetEditor::ring
(
    const label tet,
    const edge& e,
    DynamicList<label>& points,
    DynamicList<label>& tets
) const
{
    points.clear();
    tets.clear();

    // The two other points, in the order in which the tetrahedron is alike
    label from = -1;
    label to = -1;
    for (const label p : tets_[tet])
    {
        if (!e.found(p))
        {
            (from < 0 ? from : to) = p;
        }
    }
    if (!isAlike(tets_[tet], {e.first(), e.second(), from, to}))
    {
        Swap(from, to);
    }

    label t = tet;
    do
    {
        points.append(from);
        tets.append(t);

        const label next = neighbours_[t][tets_[t].find(from)];
        if (next < 0)
        {
            points.clear();
            tets.clear();
            return;
        }

        label p = -1;
        for (const label q : tets_[next])
        {
            p = e.found(q) || q == to ? p : q;
        }

        from = to;
        to = p;
        t = next;
    }
    while (t != tet);
}


labelList tetEditor::replace(const labelUList& old, const UList<tetCell>& made)
{
    DynamicList<triFace, 64> outerFaces;
    DynamicList<label, 64> outerTets;
    for (const label t : old)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (neighbours_[t][i] < 0 || !old.found(neighbours_[t][i]))
            {
                outerFaces.append(triFace(tets_[t].face(i)));
                outerTets.append(neighbours_[t][i]);
            }
        }
    }

    for (label k = old.size(); k--;)
    {
        tets_[old[k]] = tetCell(-1, -1, -1, -1);
        unused_.append(old[k]);
    }

    labelList labels(made.size());
    forAll(made, k)
    {
        if (unused_.empty())
        {
            unused_.append(tets_.size());
            tets_.append(tetCell());
            neighbours_.append(FixedList<label, 4>(-1));
        }

        const label t = unused_.remove();
        labels[k] = t;
        tets_[t] = made[k];

        for (const label p : made[k])
        {
            pointTet_[p] = t;
        }
    }
    connect(labels, outerFaces, outerTets);

    return labels;
}


tetCellList tetEditor::remaining() const
{
    DynamicList<tetCell> tets(tets_.size());
    forAll(tets_, t)
    {
        if (!removed(t))
        {
            tets.append(tets_[t]);
        }
    }

    return tetCellList(std::move(tets));
}


List<FixedList<label, 4>> tetEditor::remainingNeighbours() const
{
    labelList positions(size(), -1);
    label n = 0;
    forAll(positions, t)
    {
        positions[t] = removed(t) ? -1 : n++;
    }

    List<FixedList<label, 4>> neighbours(n);
    forAll(positions, t)
    {
        for (label i = 0; !removed(t) && i < 4; ++i)
        {
            const label neighbour = neighbours_[t][i];
            neighbours[positions[t]][i] =
                neighbour < 0 ? -1 : positions[neighbour];
        }
    }

    return neighbours;
}

} // End namespace Foam

// ************************************************************************* //
