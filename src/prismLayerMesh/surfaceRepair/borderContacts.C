/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/box_intersection_d.h>

#include "borderContacts.H"
#include "wallSides.H"

#include <algorithm>
#include <tuple>

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
    points.setSize
    (
        std::unique(points.begin(), points.end()) - points.begin()
    );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

} // End namespace Foam

// ************************************************************************* //
