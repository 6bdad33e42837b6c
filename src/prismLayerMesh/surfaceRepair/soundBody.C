/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundBody.H"

#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

namespace Foam
{

namespace PMP = CGAL::Polygon_mesh_processing;

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool removeIntersections(unionMesh& body)
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


bool isBody(const unionMesh& mesh)
{
    return CGAL::is_closed(mesh) && !PMP::does_self_intersect(mesh);
}


void removeNeedles(const double length, unionMesh& body)
{
    unionMesh cleaned(body);

    // No angle is larger: flips of caps would move the surface by more than the
    // length. removeSlivers flips low triangles.
    const double capCosine = -1;

    #if CGAL_VERSION_NR >= 1060000000
    PMP::remove_almost_degenerate_faces
    (
        cleaned,
        CGAL::parameters::cap_threshold(capCosine)
            .needle_threshold(4)
            .collapse_length_threshold(length)
    );
    #else
    PMP::experimental::remove_almost_degenerate_faces
    (
        cleaned, capCosine, 4, length
    );
    #endif

    if (isBody(cleaned))
    {
        body = cleaned;
    }
}

} // End namespace Foam

// ************************************************************************* //
