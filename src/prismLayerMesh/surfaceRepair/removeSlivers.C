/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boundBox.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include "ranges.H"
#include "stageProgress.H"
#include "surfacePart.H"
#include "unions.H"
#include "wallChanges.H"
#include "wallDefects.H"
#include "wallPredicates.H"
#include "wallSides.H"
#include "wallVisibility.H"

#include <cmath>
#include <iterator>
#include <set>
#include <vector>

namespace Foam
{

//- Radius of octahedra over the mean length of the edges around a contact, and
//  the least and largest radius over the diagonal of the surface's box
static constexpr scalar fillerShare = 0.3;
static constexpr scalar leastFiller = 5e-4;
static constexpr scalar largestFiller = 3e-3;

//- Radius of prisms over that of octahedra: an octahedron is around the ends of
//  the prisms that meet in it, since 0.5 < 1/sqrt(3)
static constexpr scalar prismShare = 0.5;


namespace
{

//- Points and faces of several bodies
struct bodies
{
    DynamicList<point> points;
    DynamicList<face> faces;

    //- Adds a body whose labels begin at 0
    void add(const pointField& corners, const faceList& sides)
    {
        const label first = points.size();
        points.append(corners);
        for (face f : sides)
        {
            for (label& p : f)
            {
                p += first;
            }
            faces.append(f);
        }
    }
};


void addOctahedron(const point& x, const scalar radius, bodies& all)
{
    // Axes that planes of bodies hardly have
    const vector axes[3] =
    {
        {0.80, 0.36, 0.48}, {-0.60, 0.48, 0.64}, {0.00, -0.80, 0.60}
    };
    pointField corners(6);
    for (direction k = 0; k < 3; ++k)
    {
        corners[2*k] = x - radius*axes[k];
        corners[2*k + 1] = x + radius*axes[k];
    }

    // Each face has one of two opposite corners on each axis
    faceList faces(8);
    for (label i = 0; i < 8; ++i)
    {
        faces[i] = face{i % 2, 2 + (i/2) % 2, 4 + i/4};
        if ((i % 2 + (i/2) % 2 + i/4) % 2 == 0)
        {
            faces[i].flip();
        }
    }
    all.add(corners, faces);
}


void addPrism(const point& a, const point& b, const scalar radius, bodies& all)
{
    const vector axis = normalised(b - a);
    const vector across =
        mag(axis.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0);
    const vector u = normalised(across - (across & axis)*axis);
    const vector v = axis ^ u;

    pointField corners(12);
    faceList faces(20);
    for (label i = 0; i < 6; ++i)
    {
        const scalar angle = (i + 0.3)*constant::mathematical::pi/3;
        const vector r = radius*(std::cos(angle)*u + std::sin(angle)*v);
        const label j = (i + 1) % 6;
        corners[i] = a + r;
        corners[6 + i] = b + r;
        faces[2*i] = face{i, j, 6 + j};
        faces[2*i + 1] = face{i, 6 + j, 6 + i};
    }
    for (label i = 1; i < 5; ++i)
    {
        faces[11 + i] = face{0, i + 1, i};
        faces[15 + i] = face{6, 6 + i, 7 + i};
    }
    all.add(corners, faces);
}

} // End anonymous namespace


surfaceContacts findContacts(const wallSurface& surface)
{
    const label nPoints = surface.points.size();
    const wallSides sides(makeWallSides(surface.faces, nPoints));
    surfaceContacts contacts;
    bitSet isOnContact(nPoints);
    for (label e = 0; e < sides.nEdges(); ++e)
    {
        if (sides.on(e).size() > 2)
        {
            const wallSide& s = sides.on(e)[0];
            contacts.edges.append(edge(s.low, s.high));
            isOnContact.set(s.low);
            isOnContact.set(s.high);
        }
    }

    const labelList nFans(countFans(surface));
    forAll(nFans, p)
    {
        if (nFans[p] > 1 && !isOnContact.test(p))
        {
            contacts.points.append(p);
        }
    }

    return contacts;
}


void addContactFillers(const surfaceContacts& contacts, wallSurface& surface)
{
    const label nPoints = surface.points.size();
    std::vector<scalar> lengths(nPoints, 0);
    std::vector<label> nEdges(nPoints, 0);
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            for (const label p : {e.start(), e.end()})
            {
                lengths[p] += e.mag(surface.points);
                ++nEdges[p];
            }
        }
    }
    const scalar diagonal = boundBox(surface.points, false).mag();
    const auto radius = [&](const label p)
    {
        return min
        (
            max(fillerShare*lengths[p]/nEdges[p], leastFiller*diagonal),
            largestFiller*diagonal
        );
    };

    bodies all;
    all.points = surface.points;
    all.faces = surface.faces;

    std::set<label> ends(contacts.points.begin(), contacts.points.end());
    for (const edge& e : contacts.edges)
    {
        const point a = surface.points[e.start()];
        const point b = surface.points[e.end()];
        const scalar least = min(radius(e.start()), radius(e.end()));
        addPrism(a, b, prismShare*least, all);
        ends.insert(e.start());
        ends.insert(e.end());
    }

    for (const label p : ends)
    {
        addOctahedron(surface.points[p], radius(p), all);
    }

    surface.points.transfer(all.points);
    surface.faces.transfer(all.faces);
}


// * * * * * * * * * * * * * *  Remove Slivers * * * * * * * * * * * * * * * //

namespace
{

class sliverRemover
{
    const scalar length_;
    const pointField& points_;
    faceList faces_;

    //- The faces of each point at the beginning of a sweep
    std::vector<std::vector<label>> facesOf_;

    //- Points around which nothing may change
    const bitSet& isFixed_;

    //- Points around which something has changed in this sweep, or is fixed
    bitSet isTouched_;

    void prepareSweep()
    {
        facesOf_.assign(points_.size(), std::vector<label>());
        forAll(faces_, facei)
        {
            for (const label p : faces_[facei])
            {
                facesOf_[p].push_back(facei);
            }
        }
        isTouched_ = isFixed_;
    }

    //- Faces that have both points
    std::vector<label> facesOn(const label p, const label q) const
    {
        std::vector<label> result;
        std::copy_if
        (
            facesOf_[p].begin(), facesOf_[p].end(), std::back_inserter(result),
            [&](const label facei) { return faces_[facei].found(q); }
        );

        return result;
    }

    scalar height(const face& f) const { return smallestHeight(points_, f); }

    std::set<label> neighbours(const label p) const
    {
        std::set<label> result;
        for (const label facei : facesOf_[p])
        {
            result.insert(faces_[facei].begin(), faces_[facei].end());
        }
        result.erase(p);

        return result;
    }

    void touchAround(const label p)
    {
        isTouched_.set(p);
        for (const label q : neighbours(p))
        {
            isTouched_.set(q);
        }
    }

    bool collapse(const label from, const label to)
    {
        const std::set<label> a(neighbours(from));
        const std::set<label> b(neighbours(to));
        const label nCommon =
            countOf(a, [&](const label p) { return b.count(p) > 0; });
        if (nCommon != 2)
        {
            return false;
        }

        for (const label facei : facesOf_[from])
        {
            const face& f = faces_[facei];
            face g(f);
            g[f.find(from)] = to;
            if (!f.found(to) && height(f) > length_ && !isAlong(points_, f, g))
            {
                return false;
            }
        }

        touchAround(from);
        touchAround(to);
        for (const label facei : facesOf_[from])
        {
            face& f = faces_[facei];
            f[f.find(from)] = to;
        }

        return true;
    }

    //- Removes a point of three faces that are all low, by a collapse
    bool removeSpike(const label p)
    {
        const std::vector<label>& faces = facesOf_[p];
        const auto isLow = [&](const label facei)
        {
            return height(faces_[facei]) < length_;
        };
        if (faces.size() != 3 || !allOf(faces, isLow))
        {
            return false;
        }

        const std::set<label> around(neighbours(p));

        return anyOf(around, [&](const label q)
        {
            return !isTouched_.test(q) && collapse(p, q);
        });
    }

    bool flip(const label facei)
    {
        const face& f = faces_[facei];
        const edge e(f.faceEdge(f.longestEdge(points_)));
        const std::vector<label> sides(facesOn(e[0], e[1]));
        if (sides.size() != 2)
        {
            return false;
        }

        const label other = sides[0] == facei ? sides[1] : sides[0];
        const edgeFlip flipped(f, faces_[other], e);
        const edge& made = flipped.made;
        if
        (
            made[0] == made[1] || isTouched_.test(made[1])
         || !facesOn(made[0], made[1]).empty() || !flipped.isBetter(points_)
        )
        {
            return false;
        }

        isTouched_.set(e);
        isTouched_.set(made);
        faces_[facei] = flipped.first;
        faces_[other] = flipped.second;

        return true;
    }

public:

    sliverRemover
    (
        const scalar length,
        const wallSurface& surface,
        const bitSet& isFixed
    )
    :
        length_(length),
        points_(surface.points),
        faces_(surface.faces),
        isFixed_(isFixed)
    {}

    //- Returns the number of changes
    label sweep()
    {
        prepareSweep();
        label nChanges = 0;

        const wallSides sides(makeWallSides(faces_, points_.size()));
        for (label e = 0; e < sides.nEdges(); ++e)
        {
            const label a = sides.on(e)[0].low;
            const label b = sides.on(e)[0].high;
            if
            (
                !isTouched_.test(a) && !isTouched_.test(b)
             && mag(points_[a] - points_[b]) < length_
            )
            {
                nChanges += collapse(b, a) || collapse(a, b);
            }
        }
        forAll(facesOf_, p)
        {
            nChanges += !isTouched_.test(p) && removeSpike(p);
        }
        forAll(faces_, facei)
        {
            const face& f = faces_[facei];
            if
            (
                !isTouched_.test(f[0]) && !isTouched_.test(f[1])
             && !isTouched_.test(f[2]) && height(f) < length_
            )
            {
                nChanges += flip(facei);
            }
        }

        // Triangles that have collapsed have a point twice
        faces_ = subsetList(faces_, [](const face& f)
        {
            return !hasRepeatedPoint(f);
        });

        return nChanges;
    }

    const faceList& faces() const { return faces_; }
};


//- Marks the points of faces whose visibility cone is empty
bitSet markEmptyCones(const wallSurface& surface)
{
    wallSurface used(surface);
    const labelList newLabels(removeUnusedPoints(used.faces, used.points));
    const bitSet isEmpty(used.points.size(), pointsWithEmptyCones(used));

    bitSet marked(newLabels.size());
    forAll(newLabels, p)
    {
        marked.set(p, newLabels[p] >= 0 && isEmpty.test(newLabels[p]));
    }

    return marked;
}


//- Returns the points of contacts and of faces that intersect
bitSet pointsInConflict(const wallSurface& surface)
{
    bitSet isFound(surface.points.size());
    const surfaceContacts contacts(findContacts(surface));
    isFound.set(contacts.points);
    for (const edge& e : contacts.edges)
    {
        isFound.set(e);
    }

    const bitSet none(surface.faces.size());
    for (const labelPair& pair : findIntersectingFaces(surface, none))
    {
        isFound.set(surface.faces[pair.first()]);
        isFound.set(surface.faces[pair.second()]);
    }

    return isFound;
}


//- Removes what is lower than a length. Returns the number of changes.
label removeLower(const scalar length, wallSurface& surface)
{
    static constexpr label maxSweeps = 20;

    const bitSet wasEmpty(markEmptyCones(surface));
    bitSet isFixed(surface.points.size());
    wallSurface result(surface);
    label nChanges;
    bool isSound = false;

    while (!isSound)
    {
        sliverRemover remover(length, surface, isFixed);
        nChanges = 0;
        repeatUntilStable("removing slivers", maxSweeps, [&]()
        {
            const label n = remover.sweep();
            nChanges += n;

            return n > 0;
        });
        result.faces = remover.faces();
        result.patchIDs = labelList(result.faces.size(), 0);

        bitSet conflicts(pointsInConflict(result));
        if (conflicts.none())
        {
            conflicts = markEmptyCones(result);
            conflicts -= wasEmpty;
        }
        const label nFixed = isFixed.count();
        isFixed |= conflicts;
        isSound = label(isFixed.count()) == nFixed;
    }

    removeUnusedPoints(result.faces, result.points);
    surface = result;

    return nChanges;
}

} // End anonymous namespace


label removeSlivers(const scalar length, wallSurface& surface)
{
    surface.patchIDs = labelList(surface.faces.size(), 0);
    label nChanges = 0;

    for (const scalar share : {1e-6, 1e-4, 1e-2, 1.0})
    {
        nChanges += removeLower(share*length, surface);
    }

    return nChanges;
}

} // End namespace Foam

// ************************************************************************* //
