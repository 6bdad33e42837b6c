/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "changeGuard.H"
#include "ranges.H"
#include "wallVisibility.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static vector normalOf(const labelledTriangle& t)
{
    const vector n((t.points[1] - t.points[0]) ^ (t.points[2] - t.points[0]));

    return n/max(mag(n), VSMALL);
}


//- Whether no direction is in front of all faces with these normals
static bool isBlind(const UList<vector>& normals)
{
    const vector mean(sum(normals));
    const auto isBehind = [&](const vector& n) { return (n & mean) <= 0; };

    return
        std::any_of(normals.begin(), normals.end(), isBehind)
     && makeVisibilityCone(normals).empty();
}


//- Whether two triangles intersect, or have an edge in common at which they are
//  folded onto each other
static bool isConflict
(
    const labelledTriangle& a,
    const labelledTriangle& b,
    const bool mayFold
)
{
    if (intersect(a, b))
    {
        return true;
    }

    label nCommon = 0;
    for (const label i : a.labels)
    {
        nCommon += i == b.labels[0] || i == b.labels[1] || i == b.labels[2];
    }

    return
        !mayFold && nCommon == 2
     && (normalOf(a) & normalOf(b)) < foldCosine();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

vector changeGuard::normalOf(const Face f) const
{
    vector n(Zero);
    const point& x = mesh_.point(mesh_.target(mesh_.halfedge(f)));
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
    {
        n += (mesh_.point(mesh_.source(h)) - x)
          ^ (mesh_.point(mesh_.target(h)) - x);
    }

    return n/max(mag(n), VSMALL);
}


bool changeGuard::isFolded(const Face f) const
{
    const vector n(normalOf(f));
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
    {
        const Face g = mesh_.face(mesh_.opposite(h));
        if (g != Mesh::null_face() && (n & normalOf(g)) < foldCosine())
        {
            return true;
        }
    }

    return false;
}


bool changeGuard::blinds
(
    const triangleList& made,
    const std::vector<Face>& replaced,
    const label v
) const
{
    DynamicList<vector> before;
    DynamicList<vector> after;
    for (const labelledTriangle& t : made)
    {
        if (std::count(t.labels, t.labels + 3, v))
        {
            after.append(Foam::normalOf(t));
        }
    }
    for (const Face f : v < 0 ? replaced : facesAt(Vertex(v)))
    {
        before.append(normalOf(f));
        if (std::find(replaced.begin(), replaced.end(), f) == replaced.end())
        {
            after.append(before.last());
        }
    }

    return isBlind(after) && !isBlind(before);
}


bool changeGuard::meets
(
    const triangleList& triangles,
    const Face f,
    const bool mayFold
) const
{
    // The triangles of a kept polygon are a fan
    const Halfedge first = mesh_.halfedge(f);
    for
    (
        Halfedge h = mesh_.next(first);
        mesh_.target(h) != mesh_.source(first);
        h = mesh_.next(h)
    )
    {
        const labelledTriangle other
        (
            triangleOf(mesh_.source(first), mesh_.source(h), mesh_.target(h))
        );
        const boundBox box(other.box());

        for (const labelledTriangle& t : triangles)
        {
            if (box.overlaps(t.box()) && isConflict(t, other, mayFold))
            {
                return true;
            }
        }
    }

    return false;
}


bool changeGuard::mayReplace
(
    const triangleList& made,
    const std::vector<Face>& replaced
) const
{
    const bool mayFold =
        anyOf(replaced, [&](const Face f) { return isFolded(f); });

    boundBox box(boundBox::invertedBox);
    for (auto t = made.begin(); t != made.end(); ++t)
    {
        const bool conflicts = std::any_of
        (
            made.begin(), t,
            [&](const labelledTriangle& other)
            {
                return isConflict(*t, other, mayFold);
            }
        );
        if (conflicts || t->degenerate())
        {
            return false;
        }
        box.add(t->box());
    }

    for (const labelledTriangle& t : made)
    {
        const auto blind = [&](const label v)
        {
            return blinds(made, replaced, v);
        };
        if (std::any_of(t.labels, t.labels + 3, blind))
        {
            return false;
        }
    }

    return !grid_.any
    (
        box, [&](const label i)
        {
            const Face f(i);

            return
                std::find(replaced.begin(), replaced.end(), f)
             == replaced.end()
             && meets(made, f, mayFold);
        }
    );
}

} // End namespace Foam

// ************************************************************************* //
