/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideFacets.H"
#include "convexPolyhedron.H"
#include "equalPoints.H"
#include "planeTriangulation.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class sideFacets
{
    const wallSurface& wall_;
    const offsetEnvelope& envelope_;
    const boundBox& box_;
    const scalar tolerance_;
    tetDomain& domain_;

    //- Region of each side patch; points on each side patch that are on another
    //  side patch, too
    List<planeRegion> regions_;
    List<DynamicList<label>> corners_;

    //- Points of the border of the wall, and of parts
    equalPoints labels_;

    DynamicList<label> added_;


    label labelOf(const point& x)
    {
        if (labels_.insert(x, domain_.points.size()))
        {
            added_.append(domain_.points.size());
            domain_.points.append(x);
        }

        return labels_.find(x);
    }


    void addCorner(const label p, const labelPair& sides)
    {
        if (sides.second() >= 0 && sides.first() != sides.second())
        {
            corners_[sides.first()].append(p);
            corners_[sides.second()].append(p);
        }
    }


    void addBorder()
    {
        const Map<labelPair> sides(wall_.border.pointSides());
        forAllConstIters(sides, iter)
        {
            labels_.insert(wall_.points[iter.key()], iter.key());
            addCorner(iter.key(), iter.val());
        }

        forAll(wall_.border.edges, i)
        {
            const label s = wall_.border.edgeSides[i];

            if (!wall_.border.sides[s].isPart())
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
            regions_[s].isCurved = side.isCurved();

            for (label p = 0; side.isCurved() && p < side.points.size(); ++p)
            {
                regions_[s].points.append(labelOf(side.points[p]));
            }

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
        const List<sidePatch>& sides = wall_.border.sides;
        const pointField& points = domain_.points;

        forAll(sides, s)
        {
            forAll(sides, part)
            {
                if (sides[s].isPart() || !sides[part].isPart())
                {
                    continue;
                }

                for (const edge& e : regions_[part].boundary)
                {
                    const point& a = points[e.start()];
                    const point& b = points[e.end()];

                    if (sides[s].hasEdge(a, b, tolerance_))
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
        regions_(wall.border.sides.size()),
        corners_(regions_.size())
    {}


    labelList add()
    {
        addBorder();
        addEnvelope();
        addParts();
        addEdgesOfParts();
        if (hasPlanes(wall_.border.sides) || enclosedVolume(wall_) > 0)
        {
            addPlanes();
        }

        forAll(regions_, s)
        {
            planeRegion& region = regions_[s];
            region.normal = -wall_.border.sides[s].normal;
            for (DynamicList<edge>* edges : {&region.boundary, &region.edges})
            {
                *edges = dividedEdges
                (
                    domain_.points, *edges, corners_[s], tolerance_
                );
            }
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
