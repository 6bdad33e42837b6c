/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "snapBorders.H"
#include "borderContacts.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
