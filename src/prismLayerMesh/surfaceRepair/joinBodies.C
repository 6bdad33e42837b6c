/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <cmath>

#include "unions.H"
#include "cgalMeshes.H"
#include "soundBody.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace PMP = CGAL::Polygon_mesh_processing;

//- Whether less of the surfaces of two bodies is left in what was made of them:
//  they intersect, or have parts of their surfaces in common
static bool touched
(
    const unionMesh& a,
    const unionMesh& b,
    const unionMesh& both
)
{
    return PMP::area(both) < (1 - 1e-12)*(PMP::area(a) + PMP::area(b));
}


//- Sets what is left of a body without another, if that is possible. Returns
//  whether the other one is within it.
static bool subtract(unionMesh a, unionMesh b, unionMesh& rest)
{
    const double volume = PMP::volume(a);

    return
        PMP::corefine_and_compute_difference(a, b, rest)
     && std::abs(PMP::volume(rest) - volume + PMP::volume(b)) <= 1e-9*volume;
}


//- Unites two bodies unless they are apart, or cannot be united
static bool unite(unionMesh a, unionMesh b, unionMesh& both)
{
    return PMP::corefine_and_compute_union(a, b, both) && touched(a, b, both);
}


static point centreOf(const CGAL::Bbox_3& box)
{
    return 0.5*point
    (
        box.xmin() + box.xmax(), box.ymin() + box.ymax(),
        box.zmin() + box.zmax()
    );
}


//- Bodies of which pairs are joined
class bodyJoiner
{
    const joinObserver& observer_;

    //- Lower steps between joined surfaces are removed
    double step_;

    std::vector<unionMesh> bodies_;

    //- Closed, and without intersections with themselves
    std::vector<bool> sound_;

    std::vector<CGAL::Bbox_3> boxes_;

public:

    bodyJoiner
    (
        const std::vector<unionMesh>& bodies,
        const double step,
        const joinObserver& observer
    )
    :
        observer_(observer),
        step_(step),
        bodies_(bodies),
        sound_(bodies.size()),
        boxes_(bodies.size())
    {
        for (std::size_t i = 0; i < bodies_.size(); ++i)
        {
            sound_[i] = isBody(bodies_[i]);
            boxes_[i] = PMP::bbox(bodies_[i]);
        }
    }

    const std::vector<unionMesh>& bodies() const { return bodies_; }

    //- Replaces pairs by what join makes of them until nothing changes; it
    //  returns whether it made something. Returns the number of joined bodies.
    template<class Join>
    label joinAll(const Join& join)
    {
        label nJoined = 0;

        for (std::size_t i = 0; i < bodies_.size(); ++i)
        {
            for (std::size_t j = i + 1; sound_[i] && j < bodies_.size();)
            {
                if (!sound_[j] || !CGAL::do_overlap(boxes_[i], boxes_[j]))
                {
                    ++j;
                    continue;
                }

                unionMesh both;
                observer_(centreOf(boxes_[i]), centreOf(boxes_[j]));

                if (!join(bodies_[i], bodies_[j], both))
                {
                    ++j;
                    continue;
                }

                removeNeedles(step_, both);
                bodies_[i] = both;
                boxes_[i] = PMP::bbox(both);

                // Rounded points may make its faces intersect
                sound_[i] = isBody(both);
                bodies_.erase(bodies_.begin() + j);
                boxes_.erase(boxes_.begin() + j);
                sound_.erase(sound_.begin() + j);
                ++nJoined;

                // What it has become may reach others
                j = i + 1;
            }
        }

        return nJoined;
    }
};


//- Unites bodies unless they are apart or one is within the other
static bool uniteOverlapping
(
    const unionMesh& a,
    const unionMesh& b,
    unionMesh& both
)
{
    unionMesh rest;

    return !subtract(a, b, rest) && !subtract(b, a, rest) && unite(a, b, both);
}


//- Subtracts a body from one within which it is, if they touch
static bool subtractWithin
(
    const unionMesh& a,
    const unionMesh& b,
    unionMesh& rest
)
{
    return
        (subtract(a, b, rest) || subtract(b, a, rest)) && touched(a, b, rest);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void joinBodies
(
    wallSurface& surface,
    const bool fluidOutside,
    const scalar step,
    const joinObserver& observer,
    repairSteps& steps
)
{
    unionMesh mesh;
    addFaces(surface, mesh);

    std::vector<unionMesh> bodies;
    PMP::split_connected_components(mesh, bodies);
    label nUntangled = 0;

    for (unionMesh& body : bodies)
    {
        nUntangled += removeIntersections(body);

        if (CGAL::is_closed(body) && !PMP::is_outward_oriented(body))
        {
            PMP::reverse_face_orientations(body);
        }
    }

    addStep(steps, "bodies freed of intersections with themselves", nUntangled);

    bodyJoiner joiner(bodies, step, observer);
    if (fluidOutside)
    {
        addStep(steps, "bodies united with others", joiner.joinAll(unite));
    }
    else
    {
        addStep
        (
            steps, "bodies united with others", joiner.joinAll(uniteOverlapping)
        );
        addStep
        (
            steps, "bodies cut out of the fluid", joiner.joinAll(subtractWithin)
        );
    }

    mesh.clear();
    for (const unionMesh& body : joiner.bodies())
    {
        mesh += body;
    }
    setFaces(mesh, surface);
}

} // End namespace Foam

// ************************************************************************* //
