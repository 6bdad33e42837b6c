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

struct sideFacets
{
    const wallSurface& wall;
    const offsetEnvelope& envelope;
    const boundBox& box;
    tetDomain& domain;

    const scalar tolerance = 1e-9*box.mag();

    //- Region of each side patch; points on each side patch that are on another
    //  side patch, too
    List<planeRegion> regions = List<planeRegion>(wall.border.sides.size());
    List<DynamicList<label>> corners =
        List<DynamicList<label>>(regions.size());

    //- Points of the border of the wall, and of parts
    equalPoints labels{};


    void addCorner(const label p, const labelPair& sides)
    {
        if (sides.second() >= 0 && sides.first() != sides.second())
        {
            corners[sides.first()].append(p);
            corners[sides.second()].append(p);
        }
    }


    void addBorder()
    {
        const Map<labelPair> sides(wall.border.pointSides());
        forAllConstIters(sides, iter)
        {
            labels.insert(wall.points[iter.key()], iter.key());
            addCorner(iter.key(), iter.val());
        }

        forAll(wall.border.edges, i)
        {
            const label s = wall.border.edgeSides[i];

            if (!wall.border.sides[s].isPart())
            {
                regions[s].edges.append(wall.border.edges[i]);
            }
        }
    }


    void addEnvelope()
    {
        forAll(envelope.sides, i)
        {
            const label p = wall.points.size() + i;

            for (const label s : envelope.sides[i])
            {
                if (s >= 0)
                {
                    regions[s].points.append(p);
                }
            }
            addCorner(p, envelope.sides[i]);
        }
    }


    void addParts()
    {
        forAll(regions, s)
        {
            const sidePatch& side = wall.border.sides[s];
            regions[s].isCurved = side.isCurved();

            for (label p = 0; side.isCurved() && p < side.points.size(); ++p)
            {
                regions[s].points.append
                (
                    labels.labelIn(domain.points, side.points[p])
                );
            }

            for (const edge& e : outline(side.faces))
            {
                const point& a = side.points[e.start()];
                const point& b = side.points[e.end()];
                const label end = labels.labelIn(domain.points, b);
                const label start = labels.labelIn(domain.points, a);
                regions[s].boundary.append(edge(start, end));
            }
        }
    }


    //- The edges of parts that are in side planes
    void addEdgesOfParts()
    {
        const List<sidePatch>& sides = wall.border.sides;
        const pointField& points = domain.points;

        forAll(sides, s)
        {
            forAll(sides, part)
            {
                if (sides[s].isPart() || !sides[part].isPart())
                {
                    continue;
                }

                for (const edge& e : regions[part].boundary)
                {
                    const point& a = points[e.start()];
                    const point& b = points[e.end()];

                    if (sides[s].hasEdge(a, b, tolerance))
                    {
                        regions[s].edges.append(e);
                    }
                }
            }
        }
    }


    void addPlanes()
    {
        const convexPolyhedron cut(cutBox(box, wall.border.sides));
        const label first = domain.points.size();
        domain.points.append(cut.points);

        forAll(cut.faces, facei)
        {
            const face f(labelList(cut.faces[facei] + first));
            const label s = cut.planes[facei];

            if (s >= 0)
            {
                regions[s].boundary.append(f.edges());
                continue;
            }

            for (label k = 1; k + 1 < f.size(); ++k)
            {
                domain.facets.append(face({f[0], f[k], f[k + 1]}));
            }
        }
    }


    labelList add()
    {
        addBorder();
        addEnvelope();
        const label nBefore = domain.points.size();
        addParts();
        const label nAdded = domain.points.size() - nBefore;
        addEdgesOfParts();
        if (hasPlanes(wall.border.sides) || enclosedVolume(wall) > 0)
        {
            addPlanes();
        }

        forAll(regions, s)
        {
            planeRegion& region = regions[s];
            region.normal = -wall.border.sides[s].normal;
            for (DynamicList<edge>* edges : {&region.boundary, &region.edges})
            {
                *edges = dividedEdges
                (
                    domain.points, *edges, corners[s], tolerance
                );
            }
            domain.facets.append(triangulatePlane(domain.points, region));
        }

        return identity(nAdded, nBefore);
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
    return sideFacets{wall, envelope, box, domain}.add();
}

} // End namespace Foam

// ************************************************************************* //
