/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceChanges.H"
#include "nearGiven.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef editedSurface::Mesh Mesh;
typedef editedSurface::Halfedge Halfedge;
typedef editedSurface::Edge Edge;
typedef editedSurface::Face Face;

//- Points that split edges are no further from the middle than this share of
//  the length
static constexpr scalar farFromMiddle = 0.25;

//- Edges beside one that is split are no longer than this share of it
static constexpr scalar shorter = 0.95;


static point middleOf(const editedSurface& surface, const Halfedge h)
{
    const Mesh& mesh = surface.mesh();

    return 0.5*(surface.at(mesh.source(h)) + surface.at(mesh.target(h)));
}


//- Returns the point of the given surface, or of an edge's line, that is
//  nearest to the middle of the edge; sets the line, -1 for none
static point newPointOf
(
    const editedSurface& surface,
    const Edge e,
    label& line
)
{
    const givenSurface& given = surface.given();
    const Halfedge h = surface.mesh().halfedge(e);
    const point middle(middleOf(surface, h));
    point x;
    line = surface.line(e);

    if (line >= 0)
    {
        line = given.findLine(line, middle, x);
        return x;
    }

    const auto find = [&](const Face f, point& nearest)
    {
        const scalar reach = reachOf(surface.pointsOf(f));
        given.findFace(surface.nearest(f), middle, reach, nearest);
    };
    point y;
    find(surface.mesh().face(h), x);
    find(surface.mesh().face(surface.mesh().opposite(h)), y);

    return magSqr(x - middle) <= magSqr(y - middle) ? x : y;
}


//- Whether x is near enough to the middle of an edge to split the edge there,
//  and new edges from x are shorter than the edge
static bool splits
(
    const editedSurface& surface,
    const Halfedge h,
    const point& x
)
{
    const Mesh& mesh = surface.mesh();
    const scalar length = surface.length(mesh.edge(h));
    if (mag(x - middleOf(surface, h)) > farFromMiddle*length)
    {
        return false;
    }

    for (const Halfedge g : {h, mesh.opposite(h)})
    {
        const point& across = surface.at(mesh.target(mesh.next(g)));
        if
        (
            mesh.face(g) != Mesh::null_face()
         && mag(x - across) > shorter*length
        )
        {
            return false;
        }
    }

    return true;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool splitEdge(editedSurface& surface, const Edge e)
{
    if (surface.isKept(e))
    {
        return false;
    }

    const Halfedge h = surface.mesh().halfedge(e);
    const changeGuard* guard = surface.guard();
    label line;
    const point x(newPointOf(surface, e, line));
    if (!splits(surface, h, x) || (guard && !guard->maySplit(h, x)))
    {
        return false;
    }
    surface.split(e, x, line);

    return true;
}

} // End namespace Foam

// ************************************************************************* //
