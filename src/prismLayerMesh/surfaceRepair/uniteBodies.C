/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include "stitchSurface.H"
#include "cgalMeshes.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel unionKernel;
typedef CGAL::Surface_mesh<unionKernel::Point_3> unionMesh;


//- Removes the intersections of a body with itself. Returns whether there were
//  any, all of which are gone.
static bool untangle(unionMesh& body)
{
    if (!PMP::does_self_intersect(body))
    {
        return false;
    }

    unionMesh untangled(body);

    if
    (
        !PMP::experimental::remove_self_intersections(untangled)
     || PMP::does_self_intersect(untangled)
    )
    {
        return false;
    }
    body = untangled;

    return true;
}


static bool isBody(const unionMesh& mesh)
{
    return CGAL::is_closed(mesh) && !PMP::does_self_intersect(mesh);
}


//- Unites two bodies unless they are apart, or cannot be united
static bool unite(unionMesh& a, unionMesh& b, unionMesh& both)
{
    const double volumes = PMP::volume(a) + PMP::volume(b);

    return
        PMP::corefine_and_compute_union(a, b, both)
     && PMP::volume(both) < (1 - 1e-12)*volumes;
}


//- Joins bodies to the first until nothing changes. Those that are not closed,
//  or intersect themselves, are left.
static label joinAll(std::vector<unionMesh>& bodies)
{
    std::vector<bool> sound(bodies.size());
    std::vector<CGAL::Bbox_3> boxes(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        sound[i] = isBody(bodies[i]);
        boxes[i] = PMP::bbox(bodies[i]);
    }

    label nUnited = 0;

    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        for (std::size_t j = i + 1; sound[i] && j < bodies.size();)
        {
            if (!sound[j] || !CGAL::do_overlap(boxes[i], boxes[j]))
            {
                ++j;
                continue;
            }

            unionMesh a(bodies[i]), b(bodies[j]), both;
            if (!unite(a, b, both))
            {
                ++j;
                continue;
            }

            bodies[i] = both;
            boxes[i] += boxes[j];
            bodies.erase(bodies.begin() + j);
            boxes.erase(boxes.begin() + j);
            sound.erase(sound.begin() + j);
            ++nUnited;

            // What it has become may reach others
            j = i + 1;
        }
    }

    return nUnited;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void uniteBodies(wallSurface& surface, repairSteps& steps)
{
    unionMesh mesh;
    addFaces(surface, mesh);

    std::vector<unionMesh> bodies;
    PMP::split_connected_components(mesh, bodies);
    label nUntangled = 0;

    for (unionMesh& body : bodies)
    {
        nUntangled += untangle(body);

        if (CGAL::is_closed(body) && !PMP::is_outward_oriented(body))
        {
            PMP::reverse_face_orientations(body);
        }
    }

    addStep(steps, "bodies freed of intersections with themselves", nUntangled);
    addStep(steps, "bodies united with others", joinAll(bodies));

    mesh.clear();
    for (const unionMesh& body : bodies)
    {
        mesh += body;
    }
    setFaces(mesh, surface);
}

} // End namespace Foam

// ************************************************************************* //
