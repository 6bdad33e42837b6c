/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fillContacts.H"
#include "boundBox.H"
#include "mathematicalConstants.H"
#include "wallTopologyDefects.H"

#include <cmath>
#include <set>
#include <vector>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


void addPrism
(
    const point& a,
    const point& b,
    const scalar radius,
    bodies& all
)
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

    const labelList nFans(countFans(surface, sides));
    forAll(nFans, p)
    {
        if (nFans[p] > 1 && !isOnContact.test(p))
        {
            contacts.points.append(p);
        }
    }

    return contacts;
}


void addContactFillers
(
    const surfaceContacts& contacts,
    wallSurface& surface
)
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

} // End namespace Foam

// ************************************************************************* //
