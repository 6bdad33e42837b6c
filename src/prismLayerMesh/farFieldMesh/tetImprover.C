/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetImprover.H"
#include "farFieldMeshControls.H"
#include "ranges.H"
#include "splitTets.H"
#include "tetrahedralize.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool tetImprover::replace
(
    const labelUList& old,
    const UList<tetCell>& made,
    const label newPoint
)
{
    if (!allPositive(points_, made))
    {
        return false;
    }

    const scalar before = (1 - farFieldTuned.leastGain)*violation_.ofTets(old);
    const tetCellList kept(tets_.subset(old));
    const labelList now(tets_.replace(old, made));

    if (newPoint >= 0)
    {
        move(newPoint);
    }

    if (violation_.ofTets(now, before) < before)
    {
        for (const tetCell& tet : made)
        {
            markChanged(labelList(tet));
        }
        return true;
    }
    tets_.replace(now, kept);

    return false;
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


bool tetImprover::flipFace(const label t, const label i)
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

    return replace(labelList({t, neighbour}), made);
}


bool tetImprover::removeEdge(const label t, const edge& e)
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

        if (replace(old, made))
        {
            return true;
        }
    }

    return false;
}


bool tetImprover::flip(const label t, const label i)
{
    return flipFace(t, i) || anyOf(edgesAt(t, i), [&](const auto& e)
    {
        return removeEdge(e.second, e.first);
    });
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


scalar tetImprover::gainIn(const cavity& c, const label newPoint)
{
    const scalar before = violation_.ofTets(c.tets);
    const tetCellList kept(tets_.subset(c.tets));
    const labelList now(tets_.replace(c.tets, partsOf(c, newPoint)));
    const scalar gain = before - violation_.ofTets(now);
    tets_.replace(now, kept);

    return gain;
}


bool tetImprover::split(const label t, const label i)
{
    const label newPoint = tets_.addPoint();
    points_.append(Zero);
    changed_.append(pass_);

    // The best place is the one that gains most before the point is moved
    cavity best;
    scalar most = -GREAT;

    for (const cavity& c : cavities(t, i))
    {
        points_[newPoint] = average(pointField(points_, c.common));
        const scalar gain = gainIn(c, newPoint);

        if (gain > most)
        {
            most = gain;
            best = c;
        }
    }

    points_[newPoint] = average(pointField(points_, best.common));
    if (replace(best.tets, partsOf(best, newPoint), newPoint))
    {
        return true;
    }
    tets_.removeLastPoint();
    points_.remove();
    changed_.remove();

    return false;
}

} // End namespace Foam

// ************************************************************************* //
