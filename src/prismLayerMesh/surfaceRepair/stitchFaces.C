/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Surface_mesh.h>

#include "stitchSurface.H"
#include "cgalMeshes.H"
#include "wallDefects.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel stitchKernel;
typedef CGAL::Surface_mesh<stitchKernel::Point_3> stitchMesh;


//- Removes the faces whose area is zero, exactly
static void removeWithoutArea(wallSurface& surface, repairSteps& steps)
{
    const vectorField normals(surface.faceNormals());
    DynamicList<face> kept(surface.faces.size());
    DynamicList<point> places;
    forAll(normals, facei)
    {
        const face& f = surface.faces[facei];

        if (normals[facei] != vector::zero)
        {
            kept.append(f);
        }
        else if (places.size() < 10)
        {
            places.append(surface.points[f[0]]);
        }
    }

    addStep
    (
        steps, "faces without area removed",
        surface.faces.size() - kept.size(), places
    );
    surface.faces = kept;
}


//- Polygons that run the other way than before; some of their points may have
//  got new labels
static label nTurned
(
    const std::vector<cgalPolygon>& before,
    const std::vector<cgalPolygon>& after
)
{
    label n = 0;

    for (std::size_t i = 0; i < before.size(); ++i)
    {
        const cgalPolygon& a = before[i];
        const cgalPolygon& b = after[i];
        label difference = 0;

        for (std::size_t k = 0; k < a.size(); ++k)
        {
            difference += (a[k] == b[b.size() - 1 - k]) - (a[k] == b[k]);
        }
        n += difference > 0;
    }

    return n;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void mergeEqualPoints(wallSurface& surface, repairSteps& steps)
{
    auto points = cgalPoints<stitchKernel::Point_3>(surface.points);
    auto polygons = cgalPolygons(surface.faces);

    addStep
    (
        steps, "equal points made one",
        PMP::merge_duplicate_points_in_polygon_soup(points, polygons)
    );
    surface.points.setSize(points.size());
    forAll(surface.points, p)
    {
        surface.points[p] = point(points[p].x(), points[p].y(), points[p].z());
    }
    forAll(surface.faces, facei)
    {
        const cgalPolygon& polygon = polygons[facei];
        face& f = surface.faces[facei];
        f.setSize(polygon.size());
        std::copy(polygon.begin(), polygon.end(), f.begin());
    }
}


void stitchFaces(wallSurface& surface, repairSteps& steps)
{
    removeWithoutArea(surface, steps);
    mergeEqualPoints(surface, steps);

    auto points = cgalPoints<stitchKernel::Point_3>(surface.points);
    auto polygons = cgalPolygons(surface.faces);
    const std::size_t nFaces = polygons.size();
    PMP::repair_polygon_soup
    (
        points, polygons, CGAL::parameters::require_same_orientation(false)
    );
    addStep
    (
        steps, "faces on the same points removed", nFaces - polygons.size()
    );

    const std::size_t nPoints = points.size();
    const auto before = polygons;
    PMP::orient_polygon_soup(points, polygons);
    addStep(steps, "faces turned", nTurned(before, polygons));
    addStep
    (
        steps, "points added where more than two faces or sheets met",
        points.size() - nPoints
    );

    stitchMesh mesh;
    PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
    addStep
    (
        steps, "edges stitched",
        PMP::stitch_borders
        (
            mesh, CGAL::parameters::apply_per_connected_component(true)
        )
      + PMP::stitch_borders(mesh)
    );
    mesh.collect_garbage();
    setFaces(mesh, surface);
}

} // End namespace Foam

// ************************************************************************* //
