/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideFacets.H"
#include "convexPolyhedron.H"
#include "planeTriangulation.H"

#include <array>
#include <map>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Six times the volume that the wall bounds with parts of planes
static scalar closedVolume(const wallSurface& wall)
{
    const point& origin = wall.points[0];
    scalar volume = 0;

    const auto add = [&](const faceList& faces, const pointField& points)
    {
        for (const face& f : faces)
        {
            volume += 2*((f.centre(points) - origin) & f.areaNormal(points));
        }
    };

    add(wall.faces, wall.points);
    for (const sidePatch& side : wall.border.sides)
    {
        add(side.faces, side.points);
    }

    return volume;
}


namespace
{

class sideFacets
{
    const wallSurface& wall_;
    const offsetEnvelope& envelope_;
    const boundBox& box_;
    const scalar tolerance_;
    tetDomain& domain_;

    //- Of each side patch
    List<planeRegion> regions_;

    //- Points on two side patches, and which these are
    DynamicList<label> corners_;
    DynamicList<labelPair> cornerSides_;

    //- Points of the border of the wall, and of parts, by place
    std::map<std::array<scalar, 3>, label> labels_;

    DynamicList<label> added_;


    label labelOf(const point& x)
    {
        const auto found = labels_.insert
        (
            {{x.x(), x.y(), x.z()}, domain_.points.size()}
        );

        if (found.second)
        {
            added_.append(domain_.points.size());
            domain_.points.append(x);
        }

        return found.first->second;
    }


    void addCorner(const label p, const labelPair& sides)
    {
        if (sides.second() >= 0 && sides.first() != sides.second())
        {
            corners_.append(p);
            cornerSides_.append(sides);
        }
    }


    void addBorder()
    {
        const Map<labelPair> sides(wall_.border.pointSides());
        forAllConstIters(sides, iter)
        {
            const point& x = wall_.points[iter.key()];
            labels_.insert({{x.x(), x.y(), x.z()}, iter.key()});
            addCorner(iter.key(), iter.val());
        }

        forAll(wall_.border.edges, i)
        {
            const label s = wall_.border.edgeSides[i];

            if (wall_.border.sides[s].faces.empty())
            {
                regions_[s].edges.append(wall_.border.edges[i]);
            }
        }
    }


    void addEnvelope()
    {
        forAll(envelope_.sides, i)
        {
            const label p = wall_.points.size() + i;

            for (const label s : envelope_.sides[i])
            {
                if (s >= 0)
                {
                    regions_[s].points.append(p);
                }
            }
            addCorner(p, envelope_.sides[i]);
        }
    }


    void addParts()
    {
        forAll(regions_, s)
        {
            const sidePatch& side = wall_.border.sides[s];

            for (const edge& e : outline(side.faces))
            {
                regions_[s].boundary.append
                (
                    edge
                    (
                        labelOf(side.points[e.start()]),
                        labelOf(side.points[e.end()])
                    )
                );
            }
        }
    }


    //- The edges of parts that are in side planes
    void addEdgesOfParts()
    {
        const auto isOn = [&](const label s, const edge& e)
        {
            const sidePatch& side = wall_.border.sides[s];

            return
                mag(side.distance(domain_.points[e.start()])) < tolerance_
             && mag(side.distance(domain_.points[e.end()])) < tolerance_;
        };

        forAll(regions_, s)
        {
            forAll(regions_, part)
            {
                if
                (
                    wall_.border.sides[s].faces.size()
                 || wall_.border.sides[part].faces.empty()
                )
                {
                    continue;
                }

                for (const edge& e : regions_[part].boundary)
                {
                    if (isOn(s, e))
                    {
                        regions_[s].edges.append(e);
                    }
                }
            }
        }
    }


    void addPlanes()
    {
        const convexPolyhedron cut(cutBox(box_, wall_.border.sides));
        const label first = domain_.points.size();
        domain_.points.append(cut.points);

        forAll(cut.faces, facei)
        {
            const face f(labelList(cut.faces[facei] + first));
            const label s = cut.planes[facei];

            for (label k = 1; s < 0 && k + 1 < f.size(); ++k)
            {
                domain_.facets.append(face({f[0], f[k], f[k + 1]}));
            }
            for (label k = 0; s >= 0 && k < f.size(); ++k)
            {
                regions_[s].boundary.append(f.faceEdge(k));
            }
        }
    }


    //- Edges divided by the points on two side patches that are on them
    DynamicList<edge> divided(const UList<edge>& edges, const label s) const
    {
        DynamicList<edge> result(edges.size());

        for (const edge& e : edges)
        {
            const point& a = domain_.points[e.start()];
            const vector ab(domain_.points[e.end()] - a);
            std::map<scalar, label> along;

            forAll(corners_, i)
            {
                const label p = corners_[i];
                const vector ap(domain_.points[p] - a);
                const scalar t = (ap & ab)/magSqr(ab);

                if
                (
                    cornerSides_[i].found(s)
                 && e.found(p) == false && t > 0 && t < 1
                 && mag(ap - t*ab) < tolerance_
                )
                {
                    along.insert({t, p});
                }
            }

            label start = e.start();
            for (const auto& next : along)
            {
                result.append(edge(start, next.second));
                start = next.second;
            }
            result.append(edge(start, e.end()));
        }

        return result;
    }

public:

    sideFacets
    (
        const wallSurface& wall,
        const offsetEnvelope& envelope,
        const boundBox& box,
        tetDomain& domain
    )
    :
        wall_(wall),
        envelope_(envelope),
        box_(box),
        tolerance_(1e-9*box.mag()),
        domain_(domain),
        regions_(wall.border.sides.size())
    {}


    labelList add()
    {
        bool hasPlanes = closedVolume(wall_) > 0;
        for (const sidePatch& side : wall_.border.sides)
        {
            hasPlanes = hasPlanes || side.faces.empty();
        }

        addBorder();
        addEnvelope();
        addParts();
        addEdgesOfParts();
        if (hasPlanes)
        {
            addPlanes();
        }

        forAll(regions_, s)
        {
            planeRegion& region = regions_[s];
            region.normal = -wall_.border.sides[s].normal;
            region.boundary = divided(region.boundary, s);
            region.edges = divided(region.edges, s);
            domain_.facets.append(triangulatePlane(domain_.points, region));
        }

        return labelList(std::move(added_));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList addSideFacets
(
    const wallSurface& wall,
    const offsetEnvelope& envelope,
    const boundBox& box,
    tetDomain& domain
)
{
    return sideFacets(wall, envelope, box, domain).add();
}

} // End namespace Foam

// ************************************************************************* //
