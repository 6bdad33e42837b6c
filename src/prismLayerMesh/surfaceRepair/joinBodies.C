/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/extrude.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <cmath>
#include <set>

#include "unions.H"
#include "boundBox.H"
#include "cgalMeshes.H"
#include "ListOps.H"
#include "ranges.H"
#include "soundBody.H"
#include "surfacePart.H"
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


//- Answers which bodies have a point in common with a body
class bodyNeighbourhood
{
    typedef CGAL::Side_of_triangle_mesh<unionMesh, unionKernel> sideOf;

    const unionMesh& body_;
    const sideOf::AABB_tree faces_;
    const sideOf side_;

    static const unionKernel::Point_3& firstPoint(const unionMesh& mesh)
    {
        return mesh.point(*mesh.vertices().begin());
    }

public:

    explicit bodyNeighbourhood(const unionMesh& body)
    :
        body_(body),
        faces_(body.faces().begin(), body.faces().end(), body),
        side_(faces_)
    {}

    //- Whether the surfaces meet, or a body is within the other
    bool has(const unionMesh& other) const
    {
        for (const auto f : other.faces())
        {
            const auto h = other.halfedge(f);
            const unionKernel::Triangle_3 triangle
            (
                other.point(other.source(h)),
                other.point(other.target(h)),
                other.point(other.target(other.next(h)))
            );
            if (faces_.do_intersect(triangle))
            {
                return true;
            }
        }

        return
            side_(firstPoint(other)) == CGAL::ON_BOUNDED_SIDE
         || sideOf(other)(firstPoint(body_)) == CGAL::ON_BOUNDED_SIDE;
    }
};


//- Bodies that are joined
class bodyJoiner
{
    const joinObserver& observer_;

    //- Lower steps between joined surfaces are removed
    double step_;

    std::vector<unionMesh> bodies_;

    //- Closed, and without intersections with themselves. A body that became a
    //  part of another is not.
    std::vector<bool> sound_;

    std::vector<CGAL::Bbox_3> boxes_;

    //- Returns the bodies behind a body that have a point in common with it
    DynamicList<label> neighbours(const label i) const
    {
        const bodyNeighbourhood neighbourhood(bodies_[i]);
        DynamicList<label> found;
        for (label j = i + 1; j < label(bodies_.size()); ++j)
        {
            if
            (
                sound_[j]
             && CGAL::do_overlap(boxes_[i], boxes_[j])
             && neighbourhood.has(bodies_[j])
            )
            {
                found.append(j);
            }
        }

        return found;
    }

    //- Returns bodies, of some, whose boxes are apart
    DynamicList<label> apart(const labelUList& some) const
    {
        DynamicList<label> kept;
        for (const label j : some)
        {
            const bool overlaps = anyOf(kept, [&](const label k)
            {
                return CGAL::do_overlap(boxes_[j], boxes_[k]);
            });
            if (!overlaps)
            {
                kept.append(j);
            }
        }

        return kept;
    }

    //- Joins some others to a body: join makes one body of them, which replaces
    //  the body. Returns whether join made one.
    template<class Join>
    bool joinTo(const label i, const labelUList& others, const Join& join)
    {
        unionMesh all;
        for (const label j : others)
        {
            all += bodies_[j];
        }
        observer_(centreOf(boxes_[i]), centreOf(PMP::bbox(all)));

        unionMesh both;
        if (!join(bodies_[i], all, both))
        {
            return false;
        }

        removeNeedles(step_, both);
        bodies_[i] = both;
        boxes_[i] = PMP::bbox(both);

        // Rounded points may make its faces intersect
        sound_[i] = isBody(both);
        for (const label j : others)
        {
            bodies_[j].clear();
            sound_[j] = false;
        }

        return true;
    }

    //- Joins some bodies to a body, one after the other. Returns how many.
    template<class Join>
    label joinEach(const label i, const labelUList& others, const Join& join)
    {
        label nJoined = 0;
        for (const label j : others)
        {
            nJoined += sound_[i] && joinTo(i, labelList(1, j), join);
        }

        return nJoined;
    }

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

    //- Replaces bodies that meet by what join makes of them until nothing
    //  changes; it returns whether it made something. Joins bodies that are
    //  apart to another at once if it may. Returns the number of joined bodies.
    template<class Join>
    label joinAll(const Join& join, const bool atOnce)
    {
        label nJoined = 0;

        for (label i = 0; i < label(bodies_.size()); ++i)
        {
            // What it has become may reach others
            for (label n = 1; n > 0 && sound_[i]; nJoined += n)
            {
                const DynamicList<label> some(neighbours(i));
                const DynamicList<label> group(apart(some));

                n = atOnce && group.size() > 1 && joinTo(i, group, join)
                  ? group.size()
                  : joinEach(i, some, join);
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


static void turnOutwards(unionMesh& body)
{
    if (!PMP::is_outward_oriented(body))
    {
        PMP::reverse_face_orientations(body);
    }
}


//- Makes bodies of open surfaces, such as a terrain, while bodies are joined:
//  each surface is swept against its mean normal
class sweptSheets
{
    //- By how far surfaces are swept [m]
    const double depth_;

    //- The points that the sweep has added
    std::set<unionKernel::Point_3> added_;

    bool isAdded(const point& x) const
    {
        return added_.count(unionKernel::Point_3(x.x(), x.y(), x.z()));
    }

public:

    explicit sweptSheets(const wallSurface& surface)
    :
        depth_(boundBox(surface.points, false).mag())
    {}

    void sweep(unionMesh& sheet)
    {
        // The copies of extrude_mesh are wrong if elements were removed
        sheet.collect_garbage();
        unionKernel::Vector_3 normal(CGAL::NULL_VECTOR);
        for (const auto f : sheet.faces())
        {
            normal = normal
              + PMP::face_area(f, sheet)*PMP::compute_face_normal(f, sheet);
        }

        const double length = std::sqrt(normal.squared_length());
        if (length <= 0)
        {
            return;
        }

        unionMesh body;
        const unionKernel::Vector_3 back(normal*(-depth_/length));
        PMP::extrude_mesh(sheet, body, back);
        PMP::triangulate_faces(body);
        for (const auto v : sheet.vertices())
        {
            added_.insert(sheet.point(v) + back);
        }
        sheet = body;
    }

    //- Removes the faces that the sweep has added
    void remove(wallSurface& surface) const
    {
        surface.faces = subsetList(surface.faces, [&](const face& f)
        {
            return !anyOf(f, [&](const label p)
            {
                return isAdded(surface.points[p]);
            });
        });
        removeUnusedPoints(surface.faces, surface.points);
    }
};


//- Returns the bodies of a surface, freed of intersections with themselves
static std::vector<unionMesh> makeBodies
(
    const wallSurface& surface,
    const bool fluidOutside,
    sweptSheets& sheets,
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

        if (CGAL::is_closed(body))
        {
            turnOutwards(body);
        }
        else if (fluidOutside)
        {
            sheets.sweep(body);
        }
    }
    addStep(steps, "bodies freed of intersections with themselves", nUntangled);

    return bodies;
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
    sweptSheets sheets(surface);
    const std::vector<unionMesh> bodies
    (
        makeBodies(surface, fluidOutside, sheets, steps)
    );

    bodyJoiner joiner(bodies, step, observer);
    if (fluidOutside)
    {
        addStep
        (
            steps, "bodies united with others", joiner.joinAll(unite, true)
        );
    }
    else
    {
        addStep
        (
            steps, "bodies united with others",
            joiner.joinAll(uniteOverlapping, false)
        );
        addStep
        (
            steps, "bodies cut out of the fluid",
            joiner.joinAll(subtractWithin, false)
        );
    }

    unionMesh mesh;
    for (const unionMesh& body : joiner.bodies())
    {
        mesh += body;
    }
    setFaces(mesh, surface);
    if (outline(surface.faces).empty())
    {
        addStep(steps, "low triangles removed", removeSlivers(step, surface));
    }
    sheets.remove(surface);
}

} // End namespace Foam

// ************************************************************************* //
