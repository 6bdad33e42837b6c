/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ranges.H"
#include "tetImprover.H"
#include "farFieldMeshControls.H"
#include "tetrahedralize.H"
#include "HashSet.H"
#include "ListOps.H"

namespace Foam
{

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
        while
        (
            nMoves < farFieldTuned.maxMoves && step(p, length*size, least)
        )
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
