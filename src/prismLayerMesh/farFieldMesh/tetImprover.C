/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetImprover.H"
#include "faceQuality.H"
#include "farFieldMeshControls.H"
#include "HashSet.H"
#include "ListOps.H"
#include "ranges.H"
#include "tetEditor.H"
#include "tetrahedralize.H"

namespace Foam
{

//- The triangles of layers and cut
static faceList innerTriangles(const farFieldTets& mesh)
{
    faceList triangles(mesh.hasLayers ? mesh.outerTriangles : faceList());
    triangles.append(mesh.cutTriangles);

    return triangles;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

tetViolation::tetViolation
(
    const neighbourCells& neighbours,
    const farFieldTets& mesh,
    const DynamicList<point>& points,
    const tetEditor& tets
)
:
    inner_(makeTriangleIndex(innerTriangles(mesh))),
    neighbourCells_(neighbours),
    points_(points),
    tets_(tets)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar tetViolation::ofFace(const label t, const label i) const
{
    const triFace f(tets_[t].face(i));
    const label neighbour = tets_.neighbour(t, i);
    const label triangle = neighbour < 0 ? inner_.lookup(f, -1) : -1;

    if (neighbour < 0 && triangle < 0)
    {
        return 0;
    }

    const point owner(tets_[t].tet(points_).centre());
    const point other
    (
        neighbour < 0
      ? neighbourCells_.centres[triangle]
      : tets_[neighbour].tet(points_).centre()
    );
    const FixedList<point, 3> x({points_[f[0]], points_[f[1]], points_[f[2]]});
    const faceGeometry g(x);
    const scalar toOwner = mag((g.centre - owner) & g.area);
    const scalar toNeighbour = mag((other - g.centre) & g.area);
    const scalar weight =
        min(toOwner, toNeighbour)/(toOwner + toNeighbour + VSMALL);
    const scalar target = farFieldTuned.targetCosine;
    const scalar maxSkewness = farFieldTuned.targetSkewness;
    const scalar volume = neighbour < 0 ? neighbourCells_.volumes[triangle] : 0;
    const scalar ratio = volume > 0 ? tets_[t].tet(points_).mag()/volume : 1;

    return
        pow3(nonOrthoViolation(g.area, other - owner, target)/target)
      + pow3(skewnessViolation(g, x, owner, other, maxSkewness))
      + pow3(max(1 - weight/farFieldTuned.targetWeight, scalar(0)))
      + pow3(max(1 - ratio/farFieldTuned.targetVolumeRatio, scalar(0)));
}


scalar tetViolation::ofTets(const labelUList& tets, const scalar bound) const
{
    scalar sum = 0;

    for (const label t : tets)
    {
        for (label i = 0; i < 4 && sum <= bound; ++i)
        {
            const label neighbour = tets_.neighbour(t, i);
            const bool within = neighbour >= 0 && tets.found(neighbour);

            if (!within || neighbour > t)
            {
                sum += ofFace(t, i);
            }
        }
    }

    return sum;
}


bool tetViolation::missesTargets(const label t, const label i) const
{
    return ofFace(t, i) > farFieldTuned.toleratedViolation;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool tetImprover::replace
(
    const labelUList& old,
    const UList<tetCell>& made,
    const label newPoint
)
{
    const auto flat = [&](const tetCell& tet) { return isFlat(points_, tet); };
    if (!allPositive(points_, made) || anyOf(made, flat))
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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool tetImprover::step(const label p, const scalar distance, scalar& least)
{
    const labelList around(tets_.pointTets(p));
    const point from(points_[p]);
    point to(from);
    bool moved = false;

    for (label k = 0; k < 6; ++k)
    {
        vector direction(Zero);
        direction[k/2] = k % 2 ? 1 : -1;
        points_[p] = from + distance*direction;
        const scalar trial = violation_.ofTets(around, least);

        if (trial < least && allPositive(points_, tets_.subset(around)))
        {
            least = trial;
            to = points_[p];
            moved = true;
        }
    }

    points_[p] = to;

    return moved;
}


scalar tetImprover::sizeAt(const label p) const
{
    scalar sum = 0;

    for (const label t : tets_.pointTets(p))
    {
        for (const label q : tets_[t])
        {
            sum += mag(points_[q] - points_[p]);
        }
    }

    return sum/max(3*tets_.pointTets(p).size(), 1);
}


bool tetImprover::move(const label p)
{
    const scalar size = sizeAt(p);
    scalar least = violation_.ofTets(tets_.pointTets(p));
    label nMoves = 0;

    for (const scalar length : farFieldTuned.moves)
    {
        while (nMoves < farFieldTuned.maxMoves && step(p, length*size, least))
        {
            ++nMoves;
        }
    }

    return nMoves;
}


void tetImprover::markChanged(const labelUList& points)
{
    for (const label p : points)
    {
        changed_[p] = pass_;
        touched_.append(p);
    }
}


bool tetImprover::hasChanged(const label t) const
{
    return t >= 0 && anyOf(tets_[t], [&](const label p)
    {
        return changed_[p] + 1 >= pass_;
    });
}


List<labelPair> tetImprover::allMissingTargets() const
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

    DynamicList<labelPair> faces;
    forAll(missing, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (missing[t] >> i & 1)
            {
                faces.append(labelPair(t, i));
            }
        }
    }

    return List<labelPair>(std::move(faces));
}


void tetImprover::appendFaces
(
    const label t,
    DynamicList<labelPair>& faces
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
        faces.append(labelPair(owner, j));
    }
}


const List<labelPair>& tetImprover::facesMissingTargets()
{
    // Other faces are as they were when the list was made
    DynamicList<labelPair> faces(missing_);
    inplaceUniqueSort(touched_);
    for (const label p : touched_)
    {
        for (const label t : tets_.pointTets(p))
        {
            appendFaces(t, faces);
        }
    }
    touched_.clear();
    inplaceUniqueSort(faces);

    DynamicList<labelPair> missing(faces.size());
    for (const labelPair& f : faces)
    {
        const label t = f.first();
        const label i = f.second();

        if
        (
            !tets_.removed(t) && isOwner(t, i)
         && (hasChanged(t) || hasChanged(tets_.neighbour(t, i)))
         && violation_.missesTargets(t, i)
        )
        {
            missing.append(f);
        }
    }
    missing_.transfer(missing);

    return missing_;
}


labelList tetImprover::pointsInside(const List<labelPair>& faces) const
{
    labelHashSet points;

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
                    points.insert(tets_[t][k]);
                }
            }
        }
    }

    return points.sortedToc();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool tetImprover::improve()
{
    ++pass_;
    bool better = false;

    const auto tryAll = [&](bool (tetImprover::*change)(label, label))
    {
        for (const labelPair& f : facesMissingTargets())
        {
            // What was changed before may have removed the tetrahedron
            const label t = f.first();
            if (!tets_.removed(t) && violation_.missesTargets(t, f.second()))
            {
                better = (this->*change)(t, f.second()) || better;
            }
        }
    };

    tryAll(&tetImprover::flip);

    for (const label p : pointsInside(facesMissingTargets()))
    {
        if (move(p))
        {
            better = true;
            for (const label t : tets_.pointTets(p))
            {
                markChanged(labelList(tets_[t]));
            }
        }
    }

    tryAll(&tetImprover::split);

    return better;
}

} // End namespace Foam

// ************************************************************************* //
