/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "edgeBounds.H"
#include "ranges.H"
#include "unitConversion.H"
#include "wallClearance.H"

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


// * * * * * * * * * * * * * * *  Set Lengths * * * * * * * * * * * * * * * //

//- Length of edges between two lines, in widths between these
static constexpr scalar perWidth = 2.5;

scalar edgeBounds::lengthAt
(
    const editedSurface& edited,
    const editedSurface::Vertex v,
    const scalarField& limits
) const
{
    scalar length = GREAT;
    for (const editedSurface::Halfedge h : edited.halfedgesFrom(v))
    {
        const editedSurface::Face f = edited.mesh().face(h);
        if (edited.isTriangle(f))
        {
            length = min(length, limits[edited.nearest(f)]);
            length = min(length, perWidth*edited.width(f));
        }
    }

    return max(length, controls_.minEdge);
}


scalar edgeBounds::sharpBound
(
    const editedSurface& edited,
    const editedSurface::Vertex v
) const
{
    const scalar cosine = Foam::cos(degToRad(controls_.sharpAngle));
    for (const editedSurface::Halfedge h : edited.halfedgesFrom(v))
    {
        const label line = edited.line(edited.mesh().edge(h));
        if (line >= 0 && edited.given().lineCosine(line) < cosine)
        {
            return controls_.sharpMaxEdge > 0 ? controls_.sharpMaxEdge : GREAT;
        }
    }

    return GREAT;
}


void edgeBounds::setLengths(editedSurface& edited) const
{
    const editedSurface::Mesh& mesh = edited.mesh();
    const scalarField limits(edited.given().lengths());
    const scalarField bounds(atPoints(edited.surface()));
    typedef std::pair<scalar, editedSurface::Vertex> entry;
    std::priority_queue<entry, std::vector<entry>, std::greater<entry>> queue;

    label n = 0;
    for (const editedSurface::Vertex v : mesh.vertices())
    {
        const scalar bound = min(bounds[n++], sharpBound(edited, v));
        edited.lengths[v] = min(lengthAt(edited, v, limits), bound);
        queue.emplace(edited.lengths[v], v);
    }

    while (!queue.empty())
    {
        const entry first(queue.top());
        queue.pop();
        const editedSurface::Vertex v = first.second;
        if (first.first > edited.lengths[v])
        {
            continue;
        }
        for (const editedSurface::Halfedge h : edited.halfedgesFrom(v))
        {
            const editedSurface::Vertex w = mesh.target(h);
            const scalar length = first.first
              + (controls_.growthRate - 1)*edited.length(mesh.edge(h));
            if (length < edited.lengths[w])
            {
                edited.lengths[w] = length;
                queue.emplace(length, w);
            }
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
