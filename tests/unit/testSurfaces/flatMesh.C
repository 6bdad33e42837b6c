/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flatMesh.H"
#include "bitSet.H"
#include "ListOps.H"
#include "labelPair.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace testSurfaces
{

static scalar twiceArea(const vector2D& a, const vector2D& b, const vector2D& c)
{
    return (b.x() - a.x())*(c.y() - a.y()) - (b.y() - a.y())*(c.x() - a.x());
}


static bool contains
(
    const vector2D& a,
    const vector2D& b,
    const vector2D& c,
    const vector2D& p,
    const scalar tolerance
)
{
    return
        twiceArea(a, b, p) > -tolerance
     && twiceArea(b, c, p) > -tolerance
     && twiceArea(c, a, p) > -tolerance;
}


//- Even pieces of about edgeLength
static void sampleBoundary
(
    flatMesh& mesh,
    const List<vector2D>& polygon,
    const scalar edgeLength
)
{
    forAll(polygon, i)
    {
        const vector2D& a = polygon[i];
        const vector2D& b = polygon[polygon.fcIndex(i)];
        const label n = max(label(1), label(mag(b - a)/edgeLength + 0.5));

        for (label j = 0; j < n; ++j)
        {
            mesh.points.append(a + (scalar(j)/n)*(b - a));
        }
    }

    mesh.nBoundary = mesh.points.size();
}


static bool isEar
(
    const flatMesh& mesh,
    const DynamicList<label>& loop,
    const label i,
    const scalar tolerance
)
{
    const label before = loop[loop.rcIndex(i)];
    const label after = loop[loop.fcIndex(i)];
    const vector2D& a = mesh.points[before];
    const vector2D& b = mesh.points[loop[i]];
    const vector2D& c = mesh.points[after];

    if (twiceArea(a, b, c) < tolerance)
    {
        return false;
    }

    for (const label p : loop)
    {
        if
        (
            p != before && p != loop[i] && p != after
         && contains(a, b, c, mesh.points[p], tolerance)
        )
        {
            return false;
        }
    }

    return true;
}


static void clipEars(flatMesh& mesh, const scalar tolerance)
{
    DynamicList<label> loop(identity(mesh.nBoundary));

    while (loop.size() > 2)
    {
        label i = 0;
        while (i < loop.size() && !isEar(mesh, loop, i, tolerance))
        {
            ++i;
        }

        if (i == loop.size())
        {
            FatalErrorInFunction
                << "The polygon is not simple or not counter-clockwise"
                << abort(FatalError);
        }

        FixedList<label, 3> ear;
        ear[0] = loop[loop.rcIndex(i)];
        ear[1] = loop[i];
        ear[2] = loop[loop.fcIndex(i)];
        mesh.triangles.append(ear);

        for (label j = i; j < loop.size() - 1; ++j)
        {
            loop[j] = loop[j + 1];
        }
        loop.remove();
    }
}


static bool inCircle
(
    const vector2D& a,
    const vector2D& b,
    const vector2D& c,
    const vector2D& d,
    const scalar tolerance
)
{
    const vector2D u(a - d), v(b - d), w(c - d);

    return
        magSqr(u)*(v.x()*w.y() - v.y()*w.x())
      - magSqr(v)*(u.x()*w.y() - u.y()*w.x())
      + magSqr(w)*(u.x()*v.y() - u.y()*v.x()) > tolerance;
}


//- A side of a triangle: its end points in order, triangle, place in it
struct side
{
    labelPair ends;
    label triangle;
    label place;
};


static List<side> sortedSides(const flatMesh& mesh)
{
    List<side> sides(3*mesh.triangles.size());

    forAll(mesh.triangles, i)
    {
        for (label k = 0; k < 3; ++k)
        {
            const label a = mesh.triangles[i][k];
            const label b = mesh.triangles[i][(k + 1) % 3];
            sides[3*i + k] = {labelPair(min(a, b), max(a, b)), i, k};
        }
    }

    std::sort
    (
        sides.begin(),
        sides.end(),
        [](const side& s, const side& t)
        {
            return s.ends != t.ends ? s.ends < t.ends : s.place < t.place;
        }
    );

    return sides;
}


//- Flip the edge between two triangles unless it is Delaunay
static bool flipEdge
(
    flatMesh& mesh,
    const side& one,
    const side& other,
    const scalar tolerance
)
{
    FixedList<label, 3>& s = mesh.triangles[one.triangle];
    FixedList<label, 3>& t = mesh.triangles[other.triangle];
    const label a = s[(one.place + 2) % 3];
    const label b = t[(other.place + 2) % 3];
    const label c = s[one.place];
    const label d = s[(one.place + 1) % 3];
    const UList<vector2D>& p = mesh.points;

    if (!inCircle(p[c], p[d], p[a], p[b], tolerance))
    {
        return false;
    }

    s[0] = a; s[1] = c; s[2] = b;
    t[0] = b; t[1] = d; t[2] = a;

    return true;
}


static void makeDelaunay(flatMesh& mesh, const scalar tolerance)
{
    bool flipped = true;

    while (flipped)
    {
        flipped = false;
        const List<side> sides(sortedSides(mesh));
        bitSet touched(mesh.triangles.size());

        for (label i = 1; i < sides.size(); ++i)
        {
            const side& s = sides[i - 1];
            const side& t = sides[i];

            if
            (
                s.ends == t.ends
             && !touched[s.triangle] && !touched[t.triangle]
             && flipEdge(mesh, s, t, tolerance)
            )
            {
                touched.set(s.triangle);
                touched.set(t.triangle);
                flipped = true;
            }
        }
    }
}


static void insertPoint(flatMesh& mesh, const vector2D& p)
{
    forAll(mesh.triangles, i)
    {
        const FixedList<label, 3> t(mesh.triangles[i]);
        const UList<vector2D>& q = mesh.points;

        if (contains(q[t[0]], q[t[1]], q[t[2]], p, -VSMALL))
        {
            const label n = mesh.points.size();
            mesh.points.append(p);

            mesh.triangles[i][2] = n;
            FixedList<label, 3> s(t);
            s[0] = n;
            mesh.triangles.append(s);
            s = t;
            s[1] = n;
            mesh.triangles.append(s);

            return;
        }
    }
}


static scalar boundaryDistance(const flatMesh& mesh, const vector2D& p)
{
    scalar distance = GREAT;

    for (label i = 0; i < mesh.nBoundary; ++i)
    {
        const vector2D& a = mesh.points[i];
        const vector2D ab(mesh.points[(i + 1) % mesh.nBoundary] - a);
        const scalar t =
            max(scalar(0), min(scalar(1), ((p - a) & ab)/magSqr(ab)));
        distance = min(distance, mag(p - a - t*ab));
    }

    return distance;
}


//- Equilateral lattice, away from the boundary
static DynamicList<vector2D> innerPoints
(
    const flatMesh& mesh,
    const scalar edgeLength
)
{
    vector2D low(GREAT, GREAT), high(-GREAT, -GREAT);
    for (const vector2D& p : mesh.points)
    {
        low = min(low, p);
        high = max(high, p);
    }

    DynamicList<vector2D> inner;
    const scalar dy = edgeLength*Foam::sqrt(0.75);

    for (label j = 1; low.y() + j*dy < high.y(); ++j)
    {
        // Off the lattice of the boundary, so that no point is on an edge
        scalar x = low.x() + (0.37 + 0.5*(j % 2))*edgeLength;

        for (; x < high.x(); x += edgeLength)
        {
            const vector2D p(x, low.y() + (j - 0.03)*dy);

            if (boundaryDistance(mesh, p) > 0.6*edgeLength)
            {
                inner.append(p);
            }
        }
    }

    return inner;
}

} // End namespace testSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::testSurfaces::flatMesh Foam::testSurfaces::triangulate
(
    const List<vector2D>& polygon,
    const scalar edgeLength
)
{
    const scalar tolerance = 1e-10*sqr(edgeLength);
    flatMesh mesh;

    sampleBoundary(mesh, polygon, edgeLength);
    clipEars(mesh, tolerance);
    makeDelaunay(mesh, 1e-9*pow4(edgeLength));

    // Those outside are in no triangle and are left out
    for (const vector2D& p : innerPoints(mesh, edgeLength))
    {
        insertPoint(mesh, p);
    }

    makeDelaunay(mesh, 1e-9*pow4(edgeLength));

    return mesh;
}


// ************************************************************************* //
