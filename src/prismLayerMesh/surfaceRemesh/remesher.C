/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remesher.H"
#include "ranges.H"
#include "stageProgress.H"
#include "surfaceChanges.H"
#include "unitConversion.H"
#include "wallClearance.H"

#include <algorithm>
#include <array>
#include <queue>

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void edgeBounds::applyRegions
(
    const pointField& points,
    scalarField& bounds
) const
{
    forAll(regions_, i)
    {
        const scalar maxEdge = controls_.regions[i].maxEdge;
        const scalarField distances(regions_[i].distances(points));

        forAll(points, p)
        {
            bounds[p] =
                distances[p] > 0
              ? min
                (
                    bounds[p], maxEdge + (controls_.growthRate - 1)*distances[p]
                )
              : maxEdge;
        }
    }
}


void edgeBounds::applyGaps
(
    const wallSurface& surface,
    scalarField& bounds
) const
{
    const scalar perRadius = 2*controls_.edgePerGap;
    const vectorField normals(surface.faceNormals());

    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        scalar longest = 0;
        for (const label p : f)
        {
            longest = max(longest, bounds[p]);
        }

        const scalar radius = roomAlong
        (
            search_(), f.centre(surface.points), normals[facei],
            longest/perRadius
        );
        for (const label p : f)
        {
            bounds[p] =
                min(bounds[p], max(perRadius*radius, controls_.minEdge));
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

edgeBounds::edgeBounds
(
    const wallSurface& given,
    const surfaceRemeshControls& controls,
    const PtrList<regionSearch>& regions
)
:
    controls_(controls),
    regions_(regions),
    ofPatches_(given.patchNames.size(), controls.maxEdge),
    search_(controls.edgePerGap > 0 ? new wallSearch(given) : nullptr)
{
    for (const patchEdges& entry : controls.patches)
    {
        bool matches = false;

        forAll(given.patchNames, patchi)
        {
            if (entry.patches.match(given.patchNames[patchi]))
            {
                ofPatches_[patchi] = entry.maxEdge;
                matches = true;
            }
        }

        if (!matches)
        {
            FatalErrorInFunction
                << "The entry " << entry.patches << " of surface.remesh.patches"
                << " matches no patch of the surface" << nl
                << "Its patches: " << listed(given.patchNames).c_str()
                << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalarField edgeBounds::atPoints(const wallSurface& surface) const
{
    scalarField bounds(surface.points.size(), GREAT);
    forAll(surface.faces, facei)
    {
        for (const label p : surface.faces[facei])
        {
            bounds[p] = min(bounds[p], ofPatches_[surface.patchIDs[facei]]);
        }
    }

    applyRegions(surface.points, bounds);
    if (search_.valid())
    {
        applyGaps(surface, bounds);
    }

    return bounds;
}


void edgeBounds::requirePointsInRegions(const wallSurface& surface) const
{
    forAll(regions_, i)
    {
        if (!regions_[i].contains(surface.points).found(true))
        {
            FatalErrorInFunction
                << "There is no point of the surface in the region "
                << controls_.regions[i].name << " of surface.remesh.regions"
                << nl << "Check its geometry, mode and distance"
                << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * *  Remesher * * * * * * * * * * * * * * * * //

//- Edges longer or shorter than these shares of the wanted length are split,
//  collapsed. An edge of the one length, split, is longer than the other.
static constexpr scalar longest = 4.0/3.0;
static constexpr scalar shortest = 4.0/5.0;

//- Edges are split first that are longer than so many wanted lengths
static constexpr scalar firstRatio = 32;

//- Length of edges between two lines, in widths between these
static constexpr scalar perWidth = 2.5;

//- Rounds of changes, and those after something has changed
static constexpr label nRounds = 6;
static constexpr label nFollowing = 2;
static constexpr label maxFlips = 5;

//- Angle [degrees] below which triangles are improved, and how often
static constexpr scalar smallAngle = 25;
static constexpr label nImprovements = 4;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

scalar remesher::lengthAt(const Vertex v, const scalarField& limits) const
{
    scalar length = GREAT;
    for (const Halfedge h : edited_.halfedgesFrom(v))
    {
        const Face f = mesh_.face(h);
        if (edited_.isTriangle(f))
        {
            length = min(length, limits[edited_.nearest(f)]);
            length = min(length, perWidth*edited_.width(f));
        }
    }

    return max(length, controls_.minEdge);
}


scalar remesher::sharpBound(const Vertex v) const
{
    const scalar cosine = Foam::cos(degToRad(controls_.sharpAngle));
    for (const Halfedge h : edited_.halfedgesFrom(v))
    {
        const label line = edited_.line(mesh_.edge(h));
        if (line >= 0 && edited_.given().lineCosine(line) < cosine)
        {
            return controls_.sharpMaxEdge > 0 ? controls_.sharpMaxEdge : GREAT;
        }
    }

    return GREAT;
}


void remesher::setLengths()
{
    const scalarField limits(edited_.given().lengths());
    const scalarField bounds(bounds_.atPoints(edited_.surface()));
    typedef std::pair<scalar, Vertex> entry;
    std::priority_queue<entry, std::vector<entry>, std::greater<entry>> queue;

    label n = 0;
    for (const Vertex v : mesh_.vertices())
    {
        const scalar bound = min(bounds[n++], sharpBound(v));
        edited_.lengths[v] = min(lengthAt(v, limits), bound);
        queue.emplace(edited_.lengths[v], v);
    }

    while (!queue.empty())
    {
        const entry first(queue.top());
        queue.pop();
        const Vertex v = first.second;
        if (first.first > edited_.lengths[v])
        {
            continue;
        }
        for (const Halfedge h : edited_.halfedgesFrom(v))
        {
            const Vertex w = mesh_.target(h);
            const scalar length = first.first
              + (controls_.growthRate - 1)*edited_.length(mesh_.edge(h));
            if (length < edited_.lengths[w])
            {
                edited_.lengths[w] = length;
                queue.emplace(length, w);
            }
        }
    }
}


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
        setLengths();
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
    const givenSurface& given,
    const surfaceRemeshControls& controls,
    const edgeBounds& bounds,
    const bool guarded
)
:
    controls_(controls),
    bounds_(bounds),
    edited_(given, guarded),
    mesh_(edited_.mesh())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void remesher::remesh()
{
    // Long edges first
    for (scalar ratio = firstRatio; ratio > longest; ratio /= 2)
    {
        setLengths();
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
