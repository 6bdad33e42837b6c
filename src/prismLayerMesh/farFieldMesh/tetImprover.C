/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetImprover.H"
#include "farFieldMeshControls.H"
#include "ListOps.H"
#include "ranges.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

template<class Type>
static void sortUnique(std::vector<Type>& list)
{
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

tetImprover::tetImprover
(
    const neighbourCells& neighbours,
    const farFieldTets& mesh
)
:
    nBoundaryPoints_(mesh.nBoundaryPoints),
    points_(mesh.points),
    tets_(mesh.tets, mesh.points.size()),
    violation_(neighbours, mesh, points_, tets_),
    changed_(labelList(mesh.points.size(), 0)),
    missing_(allMissingTargets())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool tetImprover::replaces
(
    const labelUList& old,
    const UList<tetCell>& made,
    const movedPoints& points,
    tetChange& change
) const
{
    const tetHole hole(violation_, old);
    tetPatch patch(hole, made, points);
    if (points.moving >= 0)
    {
        patch.move();
    }
    const scalar allowed = (1 - farFieldTuned.leastGain)*hole.violation();
    if (patch.violation(allowed) >= allowed)
    {
        return false;
    }
    change.tets = hole.tets;
    change.around = hole.around;
    change.made = made;
    change.p = points.moving;
    change.x = patch.place();

    return true;
}


DynamicList<std::pair<edge, label>> tetImprover::edgesAt
(
    const label t,
    const label i
) const
{
    DynamicList<std::pair<edge, label>> edges;
    const label neighbour = tets_.neighbour(t, i);

    for (const label cell : {t, neighbour})
    {
        for (label k = 0; cell >= 0 && k < 6; ++k)
        {
            const edge e(tets_[cell].tetEdge(k));
            const bool isShared =
                tets_[t].found(e.first()) && tets_[t].found(e.second());

            if (cell == t || !isShared)
            {
                edges.append(std::make_pair(e, cell));
            }
        }
    }

    return edges;
}


bool tetImprover::flipFace
(
    const label t,
    const label i,
    tetChange& change
) const
{
    const label neighbour = tets_.neighbour(t, i);

    if (neighbour < 0)
    {
        return false;
    }

    // The area vector of the face looks away from a
    const triFace f(tets_[t].face(i));
    const label a = tets_[t][i];
    label b = -1;
    for (const label p : tets_[neighbour])
    {
        b = f.found(p) ? b : p;
    }

    cellList made;
    for (label k = 0; k < 3; ++k)
    {
        made.append(tetCell(a, b, f[k], f[(k + 1) % 3]));
    }

    return areValid(unmoved(), made)
        && replaces(labelList({t, neighbour}), made, unmoved(), change);
}


bool tetImprover::removeEdge
(
    const label t,
    const edge& e,
    tetChange& change
) const
{
    labels around;
    labels old;
    tets_.ring(t, e, around, old);
    const label n = around.size();

    if (n < 3 || n > farFieldTuned.maxRing)
    {
        return false;
    }

    // A fan of triangles from each of the points
    for (label first = 0; first < (n == 3 ? 1 : n); ++first)
    {
        cellList made;
        for (label k = 1; k < n - 1; ++k)
        {
            const label p = around[first];
            const label q = around[(first + k) % n];
            const label r = around[(first + k + 1) % n];
            made.append(tetCell(e.first(), p, q, r));
            made.append(tetCell(e.second(), p, r, q));
        }

        if
        (
            areValid(unmoved(), made)
         && replaces(old, made, unmoved(), change)
        )
        {
            return true;
        }
    }

    return false;
}


List<tetImprover::cavity> tetImprover::cavities
(
    const label t,
    const label i
) const
{
    DynamicList<cavity> made;
    const label neighbour = tets_.neighbour(t, i);
    made.append(cavity{labelList({t}), labelList(tets_[t])});

    if (neighbour >= 0)
    {
        const triFace f(tets_[t].face(i));
        made.append
        (
            cavity{labelList({neighbour}), labelList(tets_[neighbour])}
        );
        made.append(cavity{labelList({t, neighbour}), labelList(f)});
    }

    labels around;
    labels tets;
    for (const std::pair<edge, label>& e : edgesAt(t, i))
    {
        tets_.ring(e.second, e.first, around, tets);

        if (tets.size())
        {
            made.append(cavity{tets, labelList(e.first)});
        }
    }

    return List<cavity>(std::move(made));
}


tetCellList tetImprover::partsOf(const cavity& c, const label newPoint) const
{
    cellList parts;
    for (const label t : c.tets)
    {
        appendParts(tets_[t], c.common, newPoint, parts);
    }

    return tetCellList(std::move(parts));
}


bool tetImprover::isWanted(const labelPair& f) const
{
    const label t = f.first();
    const label i = f.second();

    return !tets_.removed(t) && violation_.missesTargets(t, i);
}


// * * * * * * * * * * * * * * * * Changes * * * * * * * * * * * * * * * * * //

bool tetImprover::flip(const labelPair& f, tetChange& change) const
{
    const label t = f.first();
    const label i = f.second();

    return isWanted(f)
     && (
            flipFace(t, i, change)
         || anyOf(edgesAt(t, i), [&](const auto& e)
            {
                return removeEdge(e.second, e.first, change);
            })
        );
}


bool tetImprover::move(const label& p, tetChange& change) const
{
    const tetHole hole(violation_, tets_.star(p));
    const tetCellList around(tets_.subset(hole.tets));
    tetPatch patch(hole, around, movedPoints{points_, p, points_[p]});
    if (!patch.move())
    {
        return false;
    }
    change.tets = hole.tets;
    change.around = hole.around;
    change.made.clear();
    change.p = p;
    change.x = patch.place();

    return true;
}


bool tetImprover::split(const labelPair& f, tetChange& change) const
{
    if (!isWanted(f))
    {
        return false;
    }

    // The best place is the one that gains most before the point is moved
    cavity best;
    movedPoints bestPoints{points_, points_.size(), Zero};
    scalar most = -GREAT;
    for (const cavity& c : cavities(f.first(), f.second()))
    {
        const movedPoints points
        {
            points_, points_.size(), average(pointField(points_, c.common))
        };
        const tetHole hole(violation_, c.tets);
        const tetCellList parts(partsOf(c, points.moving));
        const scalar before = hole.violation();
        const scalar gain =
            before - tetPatch(hole, parts, points).violation(before - most);

        if (gain > most)
        {
            most = gain;
            best = c;
            bestPoints.x = points.x;
        }
    }
    const tetCellList parts(partsOf(best, bestPoints.moving));

    return areValid(bestPoints, parts)
        && replaces(best.tets, parts, bestPoints, change);
}


void tetImprover::make(const tetChange& change)
{
    labelList changed(change.tets);
    if (change.made.size())
    {
        tetCellList made(change.made);
        if (change.p >= 0)
        {
            // Changes of a round have the same label for their new points
            const label newPoint = tets_.addPoint();
            points_.append(change.x);
            changed_.append(pass_);
            for (tetCell& tet : made)
            {
                const label i = tet.find(change.p);
                if (i >= 0)
                {
                    tet[i] = newPoint;
                }
            }
        }
        changed = tets_.replace(change.tets, made);
    }
    else
    {
        points_[change.p] = change.x;
    }

    for (const label t : changed)
    {
        touched_.append(t);
        for (const label p : tets_[t])
        {
            changed_[p] = pass_;
        }
    }
}


template<class Item>
bool tetImprover::makeAll
(
    const std::vector<Item>& items,
    bool (tetImprover::*propose)(const Item&, tetChange&) const
)
{
    struct changer
    {
        tetImprover& improver;
        bool (tetImprover::*way)(const Item&, tetChange&) const;
        label nMade;

        bool propose(const Item& item, tetChange& change) const
        {
            return (improver.*way)(item, change);
        }

        bool asksAgain(const Item&) const { return false; }

        void start(const tetChange& change)
        {
            improver.make(change);
            ++nMade;
        }

        void make(const tetChange&, std::vector<Item>&) {}

        bool hasEnough() const { return false; }
    };

    changer one{*this, propose, 0};
    changeRounds<Item, tetChange>(farFieldTuned.changesInRound).run(items, one);

    return one.nMade;
}


// * * * * * * * * * * * * * * * * * Faces * * * * * * * * * * * * * * * * * //

bool tetImprover::hasChanged(const label t) const
{
    return t >= 0 && anyOf(tets_[t], [&](const label p)
    {
        return changed_[p] + 1 >= pass_;
    });
}


std::vector<labelPair> tetImprover::allMissingTargets() const
{
    // Bit i is for face i
    labelList missing(tets_.size(), 0);

    #pragma omp parallel for schedule(static, 256)
    forAll(missing, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (isOwner(t, i) && violation_.missesTargets(t, i))
            {
                missing[t] |= 1 << i;
            }
        }
    }

    std::vector<labelPair> faces;
    forAll(missing, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (missing[t] >> i & 1)
            {
                faces.push_back(labelPair(t, i));
            }
        }
    }

    return faces;
}


void tetImprover::appendFaces
(
    const label t,
    std::vector<labelPair>& faces
) const
{
    for (label i = 0; i < 4; ++i)
    {
        const label owner = isOwner(t, i) ? t : tets_.neighbour(t, i);
        label j = i;
        while (owner != t && tets_.neighbour(owner, j) != t)
        {
            j = (j + 1) % 4;
        }
        faces.push_back(labelPair(owner, j));
    }
}


std::vector<labelPair> tetImprover::facesMissingTargets()
{
    // Other faces are as they were when the list was made
    for (const label t : touched_)
    {
        if (!tets_.removed(t))
        {
            appendFaces(t, missing_);
        }
    }
    touched_.clear();
    sortUnique(missing_);

    const label n = missing_.size();
    std::vector<char> isMissing(n);

    #pragma omp parallel for schedule(static, 256)
    for (label k = 0; k < n; ++k)
    {
        const labelPair& f = missing_[k];
        isMissing[k] = isWanted(f) && isOwner(f.first(), f.second());
    }

    std::vector<labelPair> near;
    label nMissing = 0;
    for (label k = 0; k < n; ++k)
    {
        const labelPair f(missing_[k]);
        if (isMissing[k])
        {
            missing_[nMissing++] = f;
            if
            (
                hasChanged(f.first())
             || hasChanged(tets_.neighbour(f.first(), f.second()))
            )
            {
                near.push_back(f);
            }
        }
    }
    missing_.resize(nMissing);

    return near;
}


std::vector<label> tetImprover::pointsInside
(
    const std::vector<labelPair>& faces
) const
{
    std::vector<label> points;
    for (const labelPair& f : faces)
    {
        for
        (
            const label t
          : {f.first(), tets_.neighbour(f.first(), f.second())}
        )
        {
            for (label k = 0; t >= 0 && k < 4; ++k)
            {
                if (tets_[t][k] >= nBoundaryPoints_)
                {
                    points.push_back(tets_[t][k]);
                }
            }
        }
    }
    sortUnique(points);

    return points;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool tetImprover::improve()
{
    ++pass_;
    bool better = makeAll(facesMissingTargets(), &tetImprover::flip);
    better |= makeAll(pointsInside(facesMissingTargets()), &tetImprover::move);
    better |= makeAll(facesMissingTargets(), &tetImprover::split);

    return better;
}

} // End namespace Foam

// ************************************************************************* //
