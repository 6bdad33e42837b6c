/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/box_intersection_d.h>

#include "snapBorders.H"
#include "EdgeMap.H"
#include "wallSides.H"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


namespace
{

//- The edges with one face, as the face runs along them, with that face
struct surfaceBorders
{
    DynamicList<edge> edges;
    EdgeMap<label> faceOf;
    labelList points;

    explicit surfaceBorders(const wallSurface& surface)
    {
        const wallSides all
        (
            makeWallSides(surface.faces, surface.points.size())
        );

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
        points.setSize
        (
            std::unique(points.begin(), points.end()) - points.begin()
        );
    }
};

} // End anonymous namespace


//- Pairs of points nearer to each other than a gap, the nearest first
static std::vector<edge> nearPairs
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
            allFit = allFit && std::all_of
            (
                b.begin(), b.end(), [&](const label q) { return fit(p, q); }
            );
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


namespace
{

//- A point that an edge is to be divided at
struct edgePoint
{
    label edgei;

    //- Where on the edge [0, 1]
    scalar share;

    scalar distance;
};

} // End anonymous namespace


//- For each point the nearest edge that it is to divide
static std::map<label, edgePoint> pointsOnEdges
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

} // End namespace Foam

// ************************************************************************* //
