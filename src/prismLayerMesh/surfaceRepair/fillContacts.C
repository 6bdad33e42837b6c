/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fillContacts.H"
#include "boundBox.H"
#include "faceGroups.H"
#include "mathematicalConstants.H"

#include <algorithm>
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

typedef std::pair<label, label> labels2;


//- Whether faces around a point are one fan or cycle: they hang together by
//  edges at the point that have two faces
bool isOneFan
(
    const label p,
    const faceList& faces,
    const std::vector<label>& around
)
{
    // The other ends of the two edges of each face at the point
    std::vector<labels2> sides;
    for (const label facei : around)
    {
        const face& f = faces[facei];
        const label k = f.find(p);
        sides.emplace_back(f.prevLabel(k), f.nextLabel(k));
    }

    std::vector<bool> isIn(sides.size(), false);
    std::vector<std::size_t> fan{0};
    isIn[0] = true;

    for (std::size_t n = 0; n < fan.size(); ++n)
    {
        const labels2 s = sides[fan[n]];
        for (std::size_t i = 0; i < sides.size(); ++i)
        {
            const labels2 t = sides[i];
            const bool meets =
                s.first == t.first || s.first == t.second
             || s.second == t.first || s.second == t.second;

            if (!isIn[i] && meets)
            {
                isIn[i] = true;
                fan.push_back(i);
            }
        }
    }

    return fan.size() == sides.size();
}


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
    surfaceContacts contacts;
    std::vector<bool> isOnContact(surface.points.size(), false);

    const edgeFaceMap onEdges
    (
        facesOnEdges
        (
            surface.faces.size(),
            [&](const label i) -> const face& { return surface.faces[i]; }
        )
    );
    for (const auto& entry : onEdges)
    {
        if (entry.second.size() > 2)
        {
            contacts.edges.append(edge(entry.first.first, entry.first.second));
            isOnContact[entry.first.first] = true;
            isOnContact[entry.first.second] = true;
        }
    }

    std::vector<std::vector<label>> around(surface.points.size());
    forAll(surface.faces, facei)
    {
        for (const label p : surface.faces[facei])
        {
            around[p].push_back(facei);
        }
    }
    for (std::size_t p = 0; p < around.size(); ++p)
    {
        if
        (
            !isOnContact[p] && !around[p].empty()
         && !isOneFan(p, surface.faces, around[p])
        )
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
