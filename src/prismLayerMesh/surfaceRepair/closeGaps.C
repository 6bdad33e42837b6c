/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include "ranges.H"
#include "stitchSurface.H"
#include "boundBox.H"
#include "cgalMeshes.H"
#include "snapBorders.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel gapKernel;
typedef CGAL::Surface_mesh<gapKernel::Point_3> gapMesh;


static point pointOf(const gapMesh& mesh, const gapMesh::Vertex_index v)
{
    const auto& x = mesh.point(v);

    return point(x.x(), x.y(), x.z());
}


//- The points around a hole
static pointField rimOf(const gapMesh& mesh, const gapMesh::Halfedge_index h)
{
    DynamicList<point> rim;
    for (const auto v : mesh.vertices_around_face(h))
    {
        rim.append(pointOf(mesh, v));
    }

    return pointField(std::move(rim));
}


//- Whether all of the faces beside a hole are one triangle
static bool isAroundTriangle
(
    const gapMesh& mesh,
    const gapMesh::Halfedge_index h
)
{
    const auto beside = [&](const gapMesh::Halfedge_index side)
    {
        return mesh.face(mesh.opposite(side));
    };
    const auto next = mesh.next(h);

    return
        mesh.next(mesh.next(next)) == h
     && beside(next) == beside(h) && beside(mesh.next(next)) == beside(h);
}


static bool isOnPlane
(
    const pointField& rim,
    const UList<sidePatch>& planes,
    const scalar tolerance
)
{
    return anyOf(planes, [&](const sidePatch& plane)
    {
        return allOf(rim, [&](const point& x)
        {
            return mag(plane.distance(x)) < tolerance;
        });
    });
}


//- Fills holes smaller than a length [m], except on side planes, and removes
//  single triangles
static void fillHoles
(
    const scalar hole,
    const UList<sidePatch>& planes,
    const scalar tolerance,
    gapMesh& mesh,
    repairSteps& steps
)
{
    std::vector<gapMesh::Halfedge_index> holes;
    PMP::extract_boundary_cycles(mesh, std::back_inserter(holes));
    DynamicList<point> places;
    label nFilled = 0;
    label nSingle = 0;

    for (const auto h : holes)
    {
        const pointField rim(rimOf(mesh, h));

        if
        (
            boundBox(rim, false).mag() >= hole
         || isOnPlane(rim, planes, tolerance)
        )
        {
            continue;
        }

        // With another triangle it would enclose nothing
        if (isAroundTriangle(mesh, h))
        {
            CGAL::Euler::remove_face(mesh.opposite(h), mesh);
            ++nSingle;
            continue;
        }

        std::vector<gapMesh::Face_index> patch;
        PMP::triangulate_hole(mesh, h, std::back_inserter(patch));
        nFilled += !patch.empty();

        if (places.size() < 10)
        {
            places.append(average(rim));
        }
    }

    addStep(steps, "single triangles removed", nSingle);
    addStep(steps, "holes filled", nFilled, places);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void closeGaps
(
    wallSurface& surface,
    const scalar gap,
    const scalar hole,
    const UList<sidePatch>& planes,
    const scalar tolerance,
    repairSteps& steps
)
{
    gapMesh triangles;
    addFaces(surface, triangles);
    PMP::triangulate_faces(triangles);
    setFaces(triangles, surface);
    snapBorders(surface, gap);

    gapMesh mesh;
    addFaces(surface, mesh);
    addStep
    (
        steps, "edges with one face joined across gaps",
        PMP::stitch_borders(mesh)
    );
    PMP::remove_degenerate_faces(mesh);

    fillHoles(hole, planes, tolerance, mesh, steps);
    mesh.collect_garbage();
    setFaces(mesh, surface);
}

} // End namespace Foam

// ************************************************************************* //
