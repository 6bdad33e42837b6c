/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallDomain.H"
#include "backgroundMesh.H"
#include "convexPolyhedron.H"
#include "equalPoints.H"
#include "ListOps.H"
#include "planeTriangulation.H"
#include "triangleIndex.H"

namespace Foam
{

tetDomain wallAndEnvelope
(
    const wallSurface& wall,
    const offsetEnvelope& envelope
)
{
    labelList triangleFace;
    tetDomain domain;
    domain.facets = wallTriangles(wall, triangleFace);
    domain.points = wall.points;
    domain.points.append(envelope.points);

    return domain;
}


pointField bodySeeds(const wallSurface& wall, const wallSearch& search)
{
    DynamicList<point> seeds;
    for (const label facei : largestFaces(wall))
    {
        // On one triangle of the face: its centre may be off a warped face
        const face& f = wall.faces[facei];
        const triPointRef tri
        (
            wall.points[f[0]], wall.points[f[1]], wall.points[f[2]]
        );
        const vector inwards = -tri.unitNormal();
        const scalar tiny =
            domainControls::seedShare*::sqrt(f.mag(wall.points));

        const pointIndexHit hit
        (
            search.firstHit
            (
                tri.centre() + tiny*inwards,
                tri.centre() + search.bounds().mag()*inwards
            )
        );

        // Without a hit the inner side is the outside, and not meshed anyway
        if (hit.hit())
        {
            seeds.append(0.5*(tri.centre() + hit.rawPoint()));
        }
    }

    return pointField(std::move(seeds));
}


boundBox boxAround(const pointField& points, const offsetEnvelope& envelope)
{
    boundBox box(points);
    box.inflate(domainControls::boxShare);
    const vector margin =
        point::uniform(domainControls::boxHeights*max(envelope.radius));
    box.min() -= margin;
    box.max() += margin;

    return box;
}


void addBox(const boundBox& box, tetDomain& domain)
{
    const label first = domain.points.size();
    domain.points.append(box.points());

    // In the order of boundBox::points
    static const label faces[6][4] =
    {
        {0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
        {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}
    };

    for (const label (&f)[4] : faces)
    {
        domain.facets.append(face({first+f[0], first+f[1], first+f[2]}));
        domain.facets.append(face({first+f[0], first+f[2], first+f[3]}));
    }
}


// * * * * * * * * * * * * * * *  Front Tets * * * * * * * * * * * * * * * * //

namespace
{

//- Triangles, and the points that have any
class frontTriangles
{
    const triangleIndex index_;
    boolList hasTriangle_;

public:

    frontTriangles(const faceList& triangles, const label nPoints)
    :
        index_(makeTriangleIndex(triangles)),
        hasTriangle_(nPoints, false)
    {
        for (const face& f : triangles)
        {
            UIndirectList<bool>(hasTriangle_, f) = true;
        }
    }

    //- The triangle of a face, -1 if it is none
    label find(const triFace& f) const
    {
        return hasTriangle_[f[0]] && hasTriangle_[f[1]] && hasTriangle_[f[2]]
          ? index_.lookup(f, -1) : -1;
    }
};

} // End anonymous namespace


boolList isOnFront
(
    const pointField& points,
    const tetCellList& tets,
    const faceList& triangles,
    const label nFirst,
    const std::function<bool(label)>& isPassed
)
{
    const frontTriangles barrier(triangles, points.size());
    const List<FixedList<label, 4>> neighbours
    (
        tetNeighbours(tets, points.size())
    );
    boolList isFront(tets.size(), false);
    DynamicList<label> found;

    const auto visit = [&](const label t)
    {
        if (t >= 0 && !isFront[t])
        {
            isFront[t] = true;
            found.append(t);
        }
    };

    forAll(tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label triangle = barrier.find(tets[t].face(i));

            if (triangle >= 0 && triangle < nFirst)
            {
                const face& f = triangles[triangle];
                const vector up(points[tets[t][i]] - points[f[0]]);
                visit((f.areaNormal(points) & up) > 0 ? t : -1);
            }
        }
    }

    for (label k = 0; k < found.size(); ++k)
    {
        for (label i = 0; i < 4; ++i)
        {
            const triFace f(tets[found[k]].face(i));

            if
            (
                barrier.find(f) < 0
             && (isPassed(f[0]) || isPassed(f[1]) || isPassed(f[2]))
            )
            {
                visit(neighbours[found[k]][i]);
            }
        }
    }

    return isFront;
}


// * * * * * * * * * * * * * * *  Side Facets  * * * * * * * * * * * * * * * //

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
    List<DynamicList<label>> corners = List<DynamicList<label>>(regions.size());

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


    //- The label of the point at x. A point of the envelope on two sides can
    //  be where three sides meet: then it is the point at x but for rounding.
    label labelAt(const point& x)
    {
        if (labels.find(x) >= 0)
        {
            return labels.find(x);
        }

        for (const DynamicList<label>& onTwoSides : corners)
        {
            for (const label p : onTwoSides)
            {
                if (mag(domain.points[p] - x) < tolerance)
                {
                    return p;
                }
            }
        }

        return labels.labelIn(domain.points, x);
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
                regions[s].points.append(labelAt(side.points[p]));
            }

            for (const edge& e : outline(side.faces))
            {
                const point& a = side.points[e.start()];
                const point& b = side.points[e.end()];
                const label end = labelAt(b);
                const label start = labelAt(a);
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
        labelList cutLabels(cut.points.size());
        forAll(cutLabels, p)
        {
            cutLabels[p] = labelAt(cut.points[p]);
        }

        forAll(cut.faces, facei)
        {
            const face f(renumber(cutLabels, cut.faces[facei]));
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
