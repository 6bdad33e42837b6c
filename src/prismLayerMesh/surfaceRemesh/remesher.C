/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remesher.H"
#include "stageProgress.H"
#include "surfaceChanges.H"
#include "unitConversion.H"

#include <algorithm>
#include <array>

namespace Foam
{

//- Edges longer or shorter than these shares of the wanted length are split,
//  collapsed. An edge of the one length, split, is longer than the other.
static constexpr scalar longest = 4.0/3.0;
static constexpr scalar shortest = 4.0/5.0;

//- Edges are split first that are longer than so many wanted lengths
static constexpr scalar firstRatio = 32;

//- Rounds of changes, and those after something has changed
static constexpr label nRounds = 6;
static constexpr label nFollowing = 2;
static constexpr label maxFlips = 5;

//- Angle [degrees] below which triangles are improved, and how often
static constexpr scalar smallAngle = 25;
static constexpr label nImprovements = 4;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void remesher::split(const scalar ratio)
{
    // The longest first: in flat triangles others might be split for ever
    std::vector<std::pair<scalar, Edge>> edges;
    label nSplit = 0;
    do
    {
        nSplit = 0;
        edges.clear();
        for (const Edge e : mesh_.edges())
        {
            if (edited_.ratio(e) > ratio)
            {
                edges.emplace_back(edited_.length(e), e);
            }
        }
        std::sort(edges.rbegin(), edges.rend());
        for (const auto& e : edges)
        {
            nSplit += splitEdge(edited_, e.second);
        }
    }
    while (nSplit);
}


void remesher::collapse()
{
    for (unsigned e = 0; e < mesh_.num_edges(); ++e)
    {
        const Edge edge(e);
        if (mesh_.is_removed(edge) || edited_.ratio(edge) >= shortest)
        {
            continue;
        }
        if (!collapseEdge(edited_, mesh_.halfedge(edge, 0), longest))
        {
            collapseEdge(edited_, mesh_.halfedge(edge, 1), longest);
        }
    }
}


void remesher::flip()
{
    repeatUntilStable("flipping remeshed edges", maxFlips, [&]()
    {
        label nFlips = 0;
        for (const Edge e : mesh_.edges())
        {
            nFlips += flipEdge(edited_, e);
        }

        return nFlips > 0;
    });
}


void remesher::smooth()
{
    for (const Vertex v : mesh_.vertices())
    {
        smoothVertex(edited_, v);
    }
}


void remesher::changeEdges(const label nRounds)
{
    for (label round = 0; round < nRounds; ++round)
    {
        tellProgress("remeshing, round", round + 1, nRounds);
        setLengths_(edited_);
        split(longest);
        collapse();
        flip();
        smooth();
    }
}


void remesher::improve()
{
    const scalar small = degToRad(smallAngle);
    for (unsigned i = 0; i < mesh_.num_faces(); ++i)
    {
        const Face f(i);
        if
        (
            mesh_.is_removed(f) || !edited_.isTriangle(f)
         || edited_.smallestAngle(f) >= small
        )
        {
            continue;
        }

        std::array<Halfedge, 3> sides;
        sides[0] = mesh_.halfedge(f);
        sides[1] = mesh_.next(sides[0]);
        sides[2] = mesh_.next(sides[1]);
        std::sort
        (
            sides.begin(), sides.end(), [&](const Halfedge g, const Halfedge h)
            {
                return edited_.length(mesh_.edge(g))
                  < edited_.length(mesh_.edge(h));
            }
        );

        if
        (
            flipEdge(edited_, mesh_.edge(sides[2]))
         || flipEdge(edited_, mesh_.edge(sides[1]))
         || collapseEdge(edited_, sides[0], sqr(longest))
         || collapseEdge(edited_, mesh_.opposite(sides[0]), sqr(longest))
        )
        {
            continue;
        }
        for (const Halfedge h : sides)
        {
            optimiseVertex(edited_, mesh_.target(h));
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

remesher::remesher
(
    editedSurface& edited,
    const std::function<void(editedSurface&)>& setLengths
)
:
    edited_(edited),
    mesh_(edited.mesh()),
    setLengths_(setLengths)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void remesher::remesh()
{
    // Long edges first
    for (scalar ratio = firstRatio; ratio > longest; ratio /= 2)
    {
        setLengths_(edited_);
        flip();
        split(ratio);
    }
    changeEdges(nRounds);
    follow();
}


void remesher::follow()
{
    changeEdges(nFollowing);

    for (label n = 0; n < nImprovements; ++n)
    {
        improve();
        flip();
    }
}

} // End namespace Foam

// ************************************************************************* //
