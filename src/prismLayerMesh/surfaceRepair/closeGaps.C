/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boundBox.H"
#include "cgalMeshes.H"
#include "ranges.H"
#include "stitchSurface.H"
#include "wallSides.H"

#include <algorithm>
#include <tuple>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

namespace Foam
{

typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, label> labelledBox;


//- The box of two points, larger by a distance on all sides
static labelledBox boxOf
(
    const point& a,
    const point& b,
    const scalar distance,
    const label labeli
)
{
    const point low(min(a, b) - vector::uniform(distance));
    const point high(max(a, b) + vector::uniform(distance));
    double lows[3] = {low.x(), low.y(), low.z()};
    double highs[3] = {high.x(), high.y(), high.z()};

    return labelledBox(lows, highs, labeli);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

surfaceBorders::surfaceBorders(const wallSurface& surface)
{
    const wallSides all(makeWallSides(surface));

    for (label e = 0; e < all.nEdges(); ++e)
    {
        if (all.on(e).size() == 1)
        {
            const wallSide& side = all.on(e)[0];
            edges.append(side.along());
            faceOf.insert(side.along(), side.facei);
            points.append(side.low);
            points.append(side.high);
        }
    }
    std::sort(points.begin(), points.end());
    points.setSize(std::unique(points.begin(), points.end()) - points.begin());
}


std::vector<edge> nearPairs
(
    const pointField& x,
    const labelUList& points,
    const scalar gap
)
{
    std::vector<labelledBox> boxes;
    for (const label p : points)
    {
        boxes.push_back(boxOf(x[p], x[p], 0.5*gap, p));
    }

    std::vector<edge> pairs;
    CGAL::box_self_intersection_d
    (
        boxes.begin(), boxes.end(),
        [&](const labelledBox& a, const labelledBox& b)
        {
            if (mag(x[a.info()] - x[b.info()]) < gap)
            {
                pairs.emplace_back
                (
                    min(a.info(), b.info()), max(a.info(), b.info())
                );
            }
        }
    );
    const auto rank = [&](const edge& pair)
    {
        return std::make_tuple(pair.mag(x), pair.first(), pair.second());
    };
    std::sort
    (
        pairs.begin(), pairs.end(),
        [&](const edge& a, const edge& b) { return rank(a) < rank(b); }
    );

    return pairs;
}


std::map<label, edgePoint> pointsOnEdges
(
    const wallSurface& surface,
    const surfaceBorders& borders,
    const scalar gap
)
{
    const pointField& x = surface.points;
    std::vector<labelledBox> points, edges;
    for (const label p : borders.points)
    {
        points.push_back(boxOf(x[p], x[p], 0, p));
    }
    forAll(borders.edges, e)
    {
        const edge& ends = borders.edges[e];
        edges.push_back(boxOf(x[ends.first()], x[ends.second()], gap, e));
    }

    std::map<label, edgePoint> nearest;
    const auto tryPoint = [&](const labelledBox& a, const labelledBox& b)
    {
        const label p = a.info();
        const edge& ends = borders.edges[b.info()];
        const point& start = x[ends.first()];
        const vector along(x[ends.second()] - start);
        const scalar share =
            ((x[p] - start) & along)/max(magSqr(along), VSMALL);
        const scalar distance = mag(x[p] - start - share*along);

        if
        (
            share <= 0 || share >= 1 || distance >= gap
         || x[p] == start || x[p] == x[ends.second()]
         || surface.faces[borders.faceOf[ends]].found(p)
        )
        {
            return;
        }

        const auto found = nearest.find(p);
        if
        (
            found == nearest.end()
         || std::make_pair(distance, b.info())
          < std::make_pair(found->second.distance, found->second.edgei)
        )
        {
            nearest[p] = edgePoint{b.info(), share, distance};
        }
    };
    CGAL::box_intersection_d
    (
        points.begin(), points.end(), edges.begin(), edges.end(), tryPoint
    );

    return nearest;
}


// * * * * * * * * * * * * * * *  Snap Borders * * * * * * * * * * * * * * * //

//- Groups of points, each nearer than a gap to all others of its group
static std::vector<std::vector<label>> pointGroups
(
    const wallSurface& surface,
    const surfaceBorders& borders,
    const scalar gap
)
{
    const pointField& x = surface.points;
    std::map<label, label> groupOf;
    std::vector<std::vector<label>> groups;
    for (const label p : borders.points)
    {
        groupOf[p] = groups.size();
        groups.push_back({p});
    }
    const auto fit = [&](const label p, const label q)
    {
        return mag(x[p] - x[q]) < gap && !borders.faceOf.found(edge(p, q));
    };

    for (const edge& pair : nearPairs(x, borders.points, gap))
    {
        auto& a = groups[groupOf[pair.first()]];
        auto& b = groups[groupOf[pair.second()]];
        bool allFit = &a != &b;

        for (const label p : a)
        {
            allFit =
                allFit && allOf(b, [&](const label q) { return fit(p, q); });
        }
        if (allFit)
        {
            for (const label q : b)
            {
                groupOf[q] = groupOf[a.front()];
                a.push_back(q);
            }
            b.clear();
        }
    }

    return groups;
}


//- Moves near points to their mean
static void joinPoints
(
    const surfaceBorders& borders,
    const scalar gap,
    wallSurface& surface
)
{
    for (const auto& group : pointGroups(surface, borders, gap))
    {
        if (group.size() > 1)
        {
            point mean(Zero);
            for (const label p : group)
            {
                mean += surface.points[p];
            }
            mean /= group.size();

            for (const label p : group)
            {
                surface.points[p] = mean;
            }
        }
    }
}


//- Divides the triangle on an edge at points in their order along the edge
static void divideEdge
(
    const edge& ends,
    const std::vector<point>& places,
    surfaceBorders& borders,
    DynamicList<point>& points,
    DynamicList<face>& faces
)
{
    const label facei = borders.faceOf[ends];
    label a = ends.first();
    const label b = ends.second();
    const face& whole = faces[facei];
    const label c = whole[whole.rcIndex(whole.find(a))];

    for (const point& x : places)
    {
        const label p = points.size();
        points.append(x);
        faces.append(face({a, p, c}));

        // The edge from c to a has another face now
        if (a == ends.first() && borders.faceOf.found(edge(c, a)))
        {
            borders.faceOf.set(edge(c, a), faces.size() - 1);
        }
        a = p;
    }
    faces[facei] = face({a, b, c});
}


void snapBorders(wallSurface& surface, const scalar gap)
{
    surfaceBorders borders(surface);
    joinPoints(borders, gap, surface);

    std::map<label, std::vector<std::pair<scalar, label>>> divided;
    for (const auto& found : pointsOnEdges(surface, borders, gap))
    {
        divided[found.second.edgei].emplace_back
        (
            found.second.share, found.first
        );
    }

    DynamicList<point> points(surface.points);
    DynamicList<face> faces(surface.faces);
    for (auto& onEdge : divided)
    {
        std::sort(onEdge.second.begin(), onEdge.second.end());
        std::vector<point> places;
        for (const auto& place : onEdge.second)
        {
            places.push_back(surface.points[place.second]);
        }

        // Equal points divide an edge once
        places.erase(std::unique(places.begin(), places.end()), places.end());
        divideEdge(borders.edges[onEdge.first], places, borders, points, faces);
    }
    surface.points = pointField(points);
    surface.faces = faceList(faces);
}


// * * * * * * * * * * * * * * *  Close Gaps * * * * * * * * * * * * * * * * //

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

    // Both sides of a gap may have been turned the other way
    const label nOpen = outline(surface.faces).size();
    repairSteps untold;
    stitchFaces(surface, untold);
    addStep
    (
        steps, "edges with one face joined across gaps",
        (nOpen - outline(surface.faces).size())/2
    );

    gapMesh mesh;
    addFaces(surface, mesh);
    PMP::remove_degenerate_faces(mesh);

    fillHoles(hole, planes, tolerance, mesh, steps);
    mesh.collect_garbage();
    setFaces(mesh, surface);
}

} // End namespace Foam

// ************************************************************************* //
