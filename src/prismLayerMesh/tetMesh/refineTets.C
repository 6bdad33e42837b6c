/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refineTets.H"
#include "changeRounds.H"
#include "stageProgress.H"
#include "tetInserter.H"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Constants that were tuned, see benchmarks/farField.md
const struct
{
    //- Points that are tried in a round
    label batch = 1024;

    //- Longest edge of a tetrahedron over the size at its centre
    scalar maxLength = 1.6;

    //- Radius of a tetrahedron over its shortest edge
    scalar maxRadius = 1.3;

    //- Least distance of a centre from other points, over the size
    scalar leastDistance = 0.7;

    //- Six times the volume of a tetrahedron over the cube of its longest edge.
    //  If it is smaller than flatVolume, the tetrahedron has no centre.
    scalar leastVolume = 0.05;
    scalar flatVolume = 1e-6;

    //- Further places in the list of wanted points, on both sides, from where a
    //  way to a wanted point is tried; points between such places
    label maxStarts = 8;
    label betweenStarts = 16;

    //- Points on a level for each one on the levels before it, and points of
    //  the levels before it for each point that is tried in a round
    label pointsPerLevel = 4;
    label pointsPerTrial = 8;
} refinerTuned;


//- A point that is to be added, and what it replaces
struct insertion
:
    public pointCavity
{
    //- Label of a wanted point, or -1
    label wanted;

    point x;

    //- Memory for the replacement
    tetInserter::workspace work;
};


class refinedTets
{
    const wantedPoints& wanted_;
    const std::function<scalar(const point&)> size_;
    const label maxTets_;

    tetInserter tets_;

    //- The first of the wanted points in each tetrahedron, and the next one in
    //  the same tetrahedron, or -1
    std::vector<label> first_;
    std::vector<label> next_;

    //- Whether wanted points are added, not centres
    bool addsWanted_ = false;

    //- Rounds in which tetrahedra ask for points
    changeRounds<label, insertion> rounds_{refinerTuned.batch};

    //- Label in the mesh of each wanted point, -1 if it is not there
    labelList labels_;


    //- Whether other points are away, and spheres around triangles of the
    //  boundary
    bool hasRoom(const insertion& ins) const;

    //- Whether a tetrahedron asks for a point; sets the point
    bool asks(label t, point& x) const;

    //- Takes the wanted points out of the cavity, and returns the first one
    label takeWanted(const insertion& ins);

    //- Gives wanted points to new tetrahedra
    void giveWanted(const insertion& ins, label first);

    //- Returns the tetrahedron with a wanted point, -1 if it was not found
    label tetWith(label i, const labelListList& tetsOf) const;

public:

    refinedTets
    (
        const wantedPoints& wanted,
        const std::function<scalar(const point&)>& size,
        const label maxTets,
        const tetMesh& mesh,
        const faceList& facets = faceList()
    );

    //- Adds the wanted points, or every few of them that are not there yet
    void addWanted(label stride = 1);

    //- Adds few of the wanted points first, and then the others between them.
    //  The first points replace most tetrahedra of a mesh of facets alone.
    void addWantedInLevels();

    void addCentres();

    //- See changeRounds: a tetrahedron asks for a point
    bool propose(label t, insertion& ins) const;
    bool asksAgain(label t);
    void start(insertion& ins);
    void make(insertion& ins, std::vector<label>& next);
    bool hasEnough() const;

    const labelList& labels() const { return labels_; }

    tetMesh mesh() const { return tets_.mesh(); }
};


refinedTets::refinedTets
(
    const wantedPoints& wanted,
    const std::function<scalar(const point&)>& size,
    const label maxTets,
    const tetMesh& mesh,
    const faceList& facets
)
:
    wanted_(wanted),
    size_(size),
    maxTets_(maxTets),
    tets_(mesh, facets),
    first_(mesh.tets.size(), -1),
    next_(wanted.points.size(), -1),
    labels_(wanted.points.size(), -1)
{}


bool refinedTets::hasRoom(const insertion& ins) const
{
    const scalar leastSqr = sqr(refinerTuned.leastDistance*size_(ins.x));
    for (const tetSide& side : ins.sides)
    {
        point centre(Zero);
        for (label k = 1; k < 4; ++k)
        {
            const point& p = tets_.corner(side.tet, (side.corner + k) % 4);
            centre += p/3;
            if (magSqr(p - ins.x) < leastSqr)
            {
                return false;
            }
        }
        const point& p = tets_.corner(side.tet, (side.corner + 1) % 4);
        if
        (
            tets_.isOnBoundary(side)
         && magSqr(ins.x - centre) < magSqr(p - centre)
        )
        {
            return false;
        }
    }

    return true;
}


bool refinedTets::asks(const label t, point& x) const
{
    scalar longest = 0;
    scalar shortest = GREAT;
    point sum(Zero);
    for (label i = 0; i < 4; ++i)
    {
        sum += tets_.corner(t, i);
        for (label j = i + 1; j < 4; ++j)
        {
            const scalar lengthSqr =
                magSqr(tets_.corner(t, i) - tets_.corner(t, j));
            longest = max(longest, lengthSqr);
            shortest = min(shortest, lengthSqr);
        }
    }

    const vector u(tets_.corner(t, 1) - tets_.corner(t, 0));
    const vector v(tets_.corner(t, 2) - tets_.corner(t, 0));
    const vector w(tets_.corner(t, 3) - tets_.corner(t, 0));
    const scalar volume6 = u & (v ^ w);
    const scalar lengthCubed = longest*std::sqrt(longest);
    if (volume6 < refinerTuned.flatVolume*lengthCubed)
    {
        return false;
    }

    const vector toCentre
    (
        (magSqr(u)*(v ^ w) + magSqr(v)*(w ^ u) + magSqr(w)*(u ^ v))
       /(2*volume6)
    );
    x = tets_.corner(t, 0) + toCentre;
    const scalar size = size_(0.25*sum);

    return
        magSqr(toCentre) > sqr(refinerTuned.leastDistance*size)
     && (
            magSqr(toCentre) > sqr(refinerTuned.maxRadius)*shortest
         || volume6 < refinerTuned.leastVolume*lengthCubed
         || longest > sqr(refinerTuned.maxLength*size)
        );
}


// * * * * * * * * * * * * * * *  Replacements * * * * * * * * * * * * * * * //

label refinedTets::takeWanted(const insertion& ins)
{
    label taken = -1;
    for (const label t : ins.tets)
    {
        for (label p = first_[t]; p >= 0;)
        {
            const label after = next_[p];
            if (p != ins.wanted)
            {
                next_[p] = taken;
                taken = p;
            }
            p = after;
        }
        first_[t] = -1;
    }

    return taken;
}


void refinedTets::giveWanted(const insertion& ins, label first)
{
    while (first >= 0)
    {
        const label after = next_[first];
        const label t = tets_.madeWith(wanted_.points[first], ins);
        next_[first] = first_[t];
        first_[t] = first;
        first = after;
    }
}


// * * * * * * * * * * * * * * * * * Rounds  * * * * * * * * * * * * * * * * //

bool refinedTets::propose(const label t, insertion& ins) const
{
    ins.wanted = first_[t];
    label container = -1;
    if (ins.wanted >= 0)
    {
        ins.x = wanted_.points[ins.wanted];
        container = t;
    }
    else if (!addsWanted_ && !tets_.hasGone(t) && asks(t, ins.x))
    {
        container = tets_.locate(ins.x, t);
    }

    return
        container >= 0
     && tets_.findCavity(ins.x, container, ins)
     && (ins.wanted >= 0 || hasRoom(ins));
}


bool refinedTets::asksAgain(const label t)
{
    // Not for this point, but for the next one in the tetrahedron
    const label p = first_[t];
    if (p >= 0)
    {
        first_[t] = next_[p];
    }

    return p >= 0;
}


void refinedTets::start(insertion& ins)
{
    tets_.setLabels(ins.x, ins);
    first_.resize(tets_.nTets(), -1);
}


void refinedTets::make(insertion& ins, std::vector<label>& next)
{
    const label taken = takeWanted(ins);
    tets_.replace(ins, ins.work);
    if (ins.wanted >= 0)
    {
        labels_[ins.wanted] = ins.added;
    }
    giveWanted(ins, taken);

    for (const label t : ins.made)
    {
        point x;
        if (addsWanted_ ? first_[t] >= 0 : asks(t, x))
        {
            next.push_back(t);
        }
    }
}


bool refinedTets::hasEnough() const
{
    tellProgress("refining tetrahedra", tets_.nTets());

    return tets_.nTets() > maxTets_;
}


// * * * * * * * * * * * * * Wanted Points, Centres  * * * * * * * * * * * * //

label refinedTets::tetWith
(
    const label i,
    const labelListList& tetsOf
) const
{
    for (label n = 0; n <= 2*refinerTuned.maxStarts; ++n)
    {
        const label away = refinerTuned.betweenStarts*((n + 1)/2);
        const label start = i + (n % 2 ? away : -away);
        if (start < 0 || start >= wanted_.near.size())
        {
            continue;
        }

        for (const label t : tetsOf[wanted_.near[start]])
        {
            const label found = tets_.locate(wanted_.points[i], t);
            if (found >= 0)
            {
                return found;
            }
        }
    }

    return -1;
}


void refinedTets::addWanted(const label stride)
{
    const labelListList tetsOf(tets_.pointTets());
    const label n = wanted_.points.size();
    std::vector<label> in(n, -1);

    #pragma omp parallel for schedule(dynamic, 64)
    for (label i = 0; i < n; i += stride)
    {
        if (labels_[i] < 0)
        {
            in[i] = tetWith(i, tetsOf);
        }
    }

    std::vector<label> asking;
    for (label i = 0; i < n; ++i)
    {
        const label t = in[i];
        if (t >= 0)
        {
            if (first_[t] < 0)
            {
                asking.push_back(t);
            }
            next_[i] = first_[t];
            first_[t] = i;
        }
    }
    addsWanted_ = true;
    rounds_.run(asking, *this);
    addsWanted_ = false;
    std::fill(first_.begin(), first_.end(), -1);
}


void refinedTets::addWantedInLevels()
{
    label stride = 1;
    while (stride*refinerTuned.pointsPerLevel < wanted_.points.size())
    {
        stride *= refinerTuned.pointsPerLevel;
    }
    for (; stride > 0; stride /= refinerTuned.pointsPerLevel)
    {
        const label nAdded = wanted_.points.size()
           /(refinerTuned.pointsPerLevel*stride);
        rounds_.setBatch
        (
            min(refinerTuned.batch, max(1, nAdded/refinerTuned.pointsPerTrial))
        );
        addWanted(stride);
    }
    rounds_.setBatch(refinerTuned.batch);
}


void refinedTets::addCentres()
{
    std::vector<char> isAsking(tets_.nTets());

    #pragma omp parallel for schedule(static)
    for (label t = 0; t < tets_.nTets(); ++t)
    {
        point x;
        isAsking[t] = !tets_.hasGone(t) && asks(t, x);
    }

    std::vector<label> asking;
    for (label t = 0; t < tets_.nTets(); ++t)
    {
        if (isAsking[t])
        {
            asking.push_back(t);
        }
    }
    rounds_.run(asking, *this);
}


} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void refineTets
(
    const wantedPoints& wanted,
    const std::function<scalar(const point&)>& size,
    const label maxTets,
    tetMesh& mesh
)
{
    refinedTets tets(wanted, size, maxTets, mesh);
    tets.addWanted();
    tets.addCentres();
    mesh = tets.mesh();
}


labelList insertPoints
(
    const wantedPoints& wanted,
    const faceList& facets,
    tetMesh& mesh
)
{
    refinedTets tets(wanted, {}, labelMax, mesh, facets);
    tets.addWantedInLevels();
    mesh = tets.mesh();

    return tets.labels();
}

} // End namespace Foam

// ************************************************************************* //
