/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetPatch.H"
#include "cellPredicates.H"
#include "farFieldMeshControls.H"
#include "ranges.H"

namespace Foam
{

bool areValid(const movedPoints& points, const UList<tetCell>& tets)
{
    return allOf(tets, [&](const tetCell& tet)
    {
        point x[4];
        for (label i = 0; i < 4; ++i)
        {
            x[i] = points[tet[i]];
        }

        return orientation(x[0], x[1], x[2], x[3]) > 0
            && !isFlat(UList<point>(x, 4), tetCell(0, 1, 2, 3));
    });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

tetHole::tetHole(const tetViolation& judge, const labelUList& tets)
:
    judge(judge),
    tets(tets)
{
    const tetEditor& all = judge.tets();
    for (const label t : tets)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label neighbour = all.neighbour(t, i);
            if (neighbour >= 0 && tets.found(neighbour))
            {
                continue;
            }
            const triFace f(all[t].face(i));
            sides.append
            (
                side{sortedSimplex(f[0], f[1], f[2]), judge.across(t, i)}
            );
            if (neighbour >= 0)
            {
                around.append(neighbour);
            }
        }
    }
}


tetPatch::tetPatch
(
    const tetHole& hole,
    const UList<tetCell>& tets,
    const movedPoints& points
)
:
    points_(points),
    tets_(tets),
    faces_(4*tets.size()),
    centres_(tets.size())
{
    // Faces with one tetrahedron so far: sides of the hole have numbers < 0
    DynamicList<std::pair<simplex, label>> open(4*tets.size());
    forAll(hole.sides, s)
    {
        open.append(std::make_pair(hole.sides[s].points, -1 - s));
    }
    forAll(tets, k)
    {
        for (label i = 0; i < 4; ++i)
        {
            const triFace f(tets[k].face(i));
            const simplex key(sortedSimplex(f[0], f[1], f[2]));
            label n = open.size() - 1;
            while (n >= 0 && open[n].first != key)
            {
                --n;
            }
            if (n < 0)
            {
                open.append(std::make_pair(key, faces_.size()));
                faces_.append(patchFace{f, k, -1, {true, Zero, 0}});
                continue;
            }
            const label found = open[n].second;
            if (found >= 0)
            {
                faces_[found].other = k;
            }
            else if (hole.sides[-1 - found].across.isCell)
            {
                faces_.append
                (
                    patchFace{f, k, -1, hole.sides[-1 - found].across}
                );
            }
            open[n] = open.last();
            open.remove();
        }
        centres_.append(Zero);
        setCentre(k);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void tetPatch::setCentre(const label k)
{
    const tetCell& tet = tets_[k];
    centres_[k] =
        0.25*(points_[tet[0]] + points_[tet[1]] + points_[tet[2]]
      + points_[tet[3]]);
}


scalar tetPatch::violationOf(const patchFace& f) const
{
    const FixedList<point, 3> x
    (
        {points_[f.points[0]], points_[f.points[1]], points_[f.points[2]]}
    );
    tetViolation::acrossFace across(f.across);
    scalar volume = 0;
    if (f.other >= 0)
    {
        across.centre = centres_[f.other];
    }
    else if (across.volume > 0)
    {
        // The centre is a quarter of the height above the face
        const vector area6((x[1] - x[0])^(x[2] - x[0]));
        volume = 4*mag(area6 & (centres_[f.own] - x[0]))/6;
    }

    return tetViolation::ofFace(x, centres_[f.own], volume, across);
}


bool tetPatch::step(const scalar distance, scalar& least)
{
    const point from(points_.x);
    point to(from);
    bool moved = false;
    for (label k = 0; k < 6; ++k)
    {
        vector direction(Zero);
        direction[k/2] = k % 2 ? 1 : -1;
        moveTo(from + distance*direction);
        const scalar trial = violation(least);
        if (trial < least && areValid(points_, tets_))
        {
            least = trial;
            to = points_.x;
            moved = true;
        }
    }
    moveTo(to);

    return moved;
}


scalar tetPatch::meanLength() const
{
    scalar sum = 0;
    for (const tetCell& tet : tets_)
    {
        for (const label q : tet)
        {
            sum += mag(points_[q] - points_.x);
        }
    }

    return sum/(3*tets_.size());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar tetHole::violation() const
{
    scalar sum = 0;
    for (const label t : tets)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label neighbour = judge.tets().neighbour(t, i);
            if (neighbour > t || !tets.found(neighbour))
            {
                sum += judge.ofFace(t, i);
            }
        }
    }

    return sum;
}


scalar tetPatch::violation(const scalar bound) const
{
    scalar sum = 0;
    for (const patchFace& f : faces_)
    {
        sum += violationOf(f);
        if (sum > bound)
        {
            break;
        }
    }

    return sum;
}


bool tetPatch::move()
{
    const scalar size = meanLength();
    scalar least = violation();
    label nMoves = 0;
    for (const scalar length : farFieldTuned.moves)
    {
        while (nMoves < farFieldTuned.maxMoves && step(length*size, least))
        {
            ++nMoves;
        }
    }

    return nMoves;
}


void tetPatch::moveTo(const point& x)
{
    points_.x = x;
    forAll(centres_, k)
    {
        setCentre(k);
    }
}

} // End namespace Foam

// ************************************************************************* //
