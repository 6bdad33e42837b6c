/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatchRemainders.H"
#include "convexPolyhedron.H"
#include "edgeHashes.H"
#include "HashSet.H"
#include "Map.H"
#include "ranges.H"
#include "sideRegions.H"
#include "surfacePart.H"

namespace Foam
{

static bool isSmooth(const sidePatch& a, const sidePatch& b, const point& x)
{
    return (a.planeAt(x).normal & b.planeAt(x).normal) > curvedCosine;
}


//- For edges of the first region that are of the second one too, in the other
//  direction, and smooth: the end of each by its start
static Map<label> commonEdges
(
    const pointField& points,
    const UList<sidePatch>& sides,
    const UList<planeRegion>& regions,
    const label s,
    const label t
)
{
    Map<label> backward;
    for (const edge& e : regions[t].boundary)
    {
        backward.insert(e.end(), e.start());
    }

    Map<label> common;
    for (const edge& e : regions[s].boundary)
    {
        if
        (
            backward.lookup(e.start(), -1) == e.end()
         && isSmooth(sides[s], sides[t], e.centre(points))
        )
        {
            common.insert(e.start(), e.end());
        }
    }

    return common;
}


//- The points of lines, in their order; a closed line begins at its lowest
static List<labelList> linesOf(const Map<label>& next)
{
    labelHashSet ends;
    forAllConstIters(next, iter)
    {
        ends.insert(iter.val());
    }

    labelHashSet done;
    DynamicList<labelList> lines;
    for (const bool isClosed : {false, true})
    {
        for (const label start : next.sortedToc())
        {
            if (done.found(start) || (!isClosed && ends.found(start)))
            {
                continue;
            }

            DynamicList<label> line;
            for (label p = start; p >= 0; p = next.lookup(p, -1))
            {
                line.append(p);
                if (!done.insert(p))
                {
                    break;
                }
            }
            lines.append(labelList(std::move(line)));
        }
    }

    return List<labelList>(std::move(lines));
}


//- The line with fewer points
static labelList coarsened
(
    const pointField& points,
    const labelList& line,
    const std::function<scalar(const point&)>& size
)
{
    // Lengths in units of the size
    scalarField at(line.size(), 0);
    for (label i = 1; i < line.size(); ++i)
    {
        const point& a = points[line[i - 1]];
        const point& b = points[line[i]];
        at[i] = at[i - 1] + mag(b - a)/size(0.5*(a + b));
    }

    const label n = max(label(::round(at.last())), label(1));
    DynamicList<label> kept;
    kept.append(line[0]);

    for (label k = 1, i = 0; k < n; ++k)
    {
        const scalar aim = at.last()*k/n;
        while (i < line.size() - 2 && mag(at[i + 1] - aim) <= mag(at[i] - aim))
        {
            ++i;
        }
        if (line[i] != kept.last())
        {
            kept.append(line[i]);
        }
    }
    kept.append(line.last());

    return labelList(std::move(kept));
}


//- Remove edges with both ends in a line, and add those of another
static void replace
(
    const labelUList& line,
    const labelUList& by,
    const bool forwards,
    planeRegion& region
)
{
    edgeHashSet gone;
    for (label i = 1; i < line.size(); ++i)
    {
        gone.insert(edge(line[i - 1], line[i]));
    }

    DynamicList<edge> left;
    for (const edge& e : region.boundary)
    {
        if (!gone.found(e))
        {
            left.append(e);
        }
    }
    for (label i = 1; i < by.size(); ++i)
    {
        left.append(forwards ? edge(by[i - 1], by[i]) : edge(by[i], by[i - 1]));
    }
    region.boundary.transfer(left);
}


void coarsenCuts
(
    const pointField& points,
    const UList<sidePatch>& sides,
    const std::function<scalar(const point&)>& size,
    List<planeRegion>& regions
)
{
    forAll(sides, s)
    {
        for (label t = s + 1; t < sides.size(); ++t)
        {
            if
            (
                !sides[s].isCurved() || !sides[t].isCurved()
             || sides[s].name != sides[t].name
            )
            {
                continue;
            }

            const Map<label> common(commonEdges(points, sides, regions, s, t));
            for (const labelList& line : linesOf(common))
            {
                const labelList fewer(coarsened(points, line, size));
                replace(line, fewer, true, regions[s]);
                replace(line, fewer, false, regions[t]);
            }
        }
    }
}


// * * * * * * * * * * * * * *  Plane Remainders * * * * * * * * * * * * * * //

farFieldBoundary makePlaneRemainders
(
    const prismLayers& layers,
    const coreCut& cut,
    const std::function<scalar(const point&)>& size
)
{
    boundBox box(layers.points, false);
    box.inflate(1);
    sideRegions on(layers, size, 1e-9*box.mag());

    const label first = on.points().size();
    on.points().append(cut.surface.points);
    forAll(on.sides, s)
    {
        // Faces that are gone are to the left seen from outside
        for (const edge& e : cut.borders[s])
        {
            const edge reversed(e.end() + first, e.start() + first);
            on.regions[s].boundary.append(reversed);
        }
        for (const edge& e : cut.limits[s])
        {
            on.regions[s].limits.append(edge(e[0] + first, e[1] + first));
        }
    }
    on.triangulate();

    return on.made;
}


// * * * * * * * * * * * * *  Side Patch Remainders  * * * * * * * * * * * * //

static bool hasAny(const edgeHashSet& all, const edgeList& edges)
{
    return anyOf(edges, [&](const edge& e) { return all.found(e); });
}


namespace
{

class farFieldBoundaryMaker
{
    const farBoundary& far_;
    const boundBox box_;
    sideRegions on_;

    //- Points of parts
    equalPoints labels_;

    static boundBox boxOf(const prismLayers& layers, const farBoundary& far)
    {
        boundBox box(far.surface.points, false);
        if (box.empty())
        {
            // Wall and side patches enclose the fluid: the box bounds nothing.
            // The corner of three planes may be outside of the box of the wall.
            box = boundBox(layers.points, false);
            for (const sidePatch& side : layers.border.sides)
            {
                box.add(side.points);
            }
            box.inflate(1);
        }
        return box;
    }

    //- Refuses layers outside of the far boundary
    void checkInBox() const
    {
        for (const point& top : on_.border.outerPoints())
        {
            // The nearest point in the box is the point itself
            const point inBox(min(max(top, box_.min()), box_.max()));

            if (far_.surface.faces.size() && mag(top - inBox) > on_.tolerance)
            {
                FatalErrorInFunction
                    << "The far boundary is not around the wall: the layers at "
                    << top << " are outside of it" << nl
                    << "Enlarge farField.boundary" << exit(FatalError);
            }
        }
    }

    void addEdge(const label s, const edge& e)
    {
        const point& a = on_.points()[e.start()];
        const point& b = on_.points()[e.end()];
        on_.regions[s].boundary.append(e);

        // A plane ends there too, seen from the other side
        forAll(on_.sides, t)
        {
            const sidePatch& side = on_.sides[t];
            if (!side.isPart() && side.hasEdge(a, b, on_.tolerance))
            {
                on_.regions[t].boundary.append(edge(e.end(), e.start()));
            }
        }
    }

    //- The outline of parts, beyond the layers
    void addParts()
    {
        forAll(on_.sides, s)
        {
            for (const edge& e : outline(on_.sides[s].faces))
            {
                const point& a = on_.sides[s].points[e.start()];
                const point& b = on_.sides[s].points[e.end()];
                labelPair ends;

                const auto labelOf = [&](const label top, const point& x)
                {
                    return top < 0 ? labels_.labelIn(on_.points(), x) : top;
                };

                if (!on_.border.covers(a, b, ends))
                {
                    const label end = labelOf(ends.second(), b);
                    const label start = labelOf(ends.first(), a);
                    addEdge(s, edge(start, end));
                }
            }
        }
    }

    //- The far boundary, cut by the planes
    convexPolyhedron cutBoundary()
    {
        const convexPolyhedron cut(cutBox(box_, on_.sides));
        const label first = on_.points().size();
        on_.points().append(cut.points);

        forAll(cut.faces, facei)
        {
            const label s = cut.planes[facei];
            const face f(labelList(cut.faces[facei] + first));

            for (label k = 0; s >= 0 && k < f.size(); ++k)
            {
                on_.regions[s].limits.append(f.faceEdge(k));
            }
        }

        return cut;
    }

    //- The sides of the box that the far field reaches
    void addBoxSides(const convexPolyhedron& cut, const label first)
    {
        edgeHashSet reached;
        for (const face& f : on_.made.surface.faces)
        {
            reached.insert(f.edges());
        }

        boolList added(cut.faces.size(), false);
        for (bool more = true; more;)
        {
            more = false;

            forAll(cut.faces, facei)
            {
                const face f(labelList(cut.faces[facei] + first));
                const edgeList edges(f.edges());

                if
                (
                    added[facei] || cut.planes[facei] >= 0
                 || !hasAny(reached, edges)
                )
                {
                    continue;
                }

                if (far_.surface.faces.empty())
                {
                    FatalErrorInFunction
                        << "The fluid is open beyond the side planes at "
                        << f.centre(on_.points()) << nl
                        << "Write: farField { boundary { type box; min (...);"
                        << " max (...); } }"
                        << exit(FatalError);
                }

                for (label k = 1; k + 1 < f.size(); ++k)
                {
                    on_.addTriangle
                    (
                        face({f[0], f[k], f[k + 1]}),
                        far_.boxPatches[cut.boxSides[facei]]
                    );
                }
                reached.insert(edges);
                added[facei] = more = true;
            }
        }
    }

public:

    farFieldBoundaryMaker
    (
        const prismLayers& layers,
        const farBoundary& far,
        const std::function<scalar(const point&)>& size
    )
    :
        far_(far),
        box_(boxOf(layers, far)),
        on_
        (
            layers, size, 1e-9*box_.mag(), far.surface.patchNames,
            far.patchTypes
        )
    {}

    farFieldBoundary make()
    {
        checkInBox();
        addParts();
        coarsenCuts(on_.points(), on_.sides, on_.size, on_.regions);

        if (hasPlanes(on_.sides))
        {
            if (far_.surface.faces.size() && far_.boxPatches.empty())
            {
                FatalErrorInFunction
                    << "With side planes the far boundary has to be a box" << nl
                    << "Write: farField { boundary { type box; min (...);"
                    << " max (...); } }" << exit(FatalError);
            }

            const label first = on_.points().size();
            const convexPolyhedron cut(cutBoundary());
            on_.triangulate();
            addBoxSides(cut, first);
        }
        else
        {
            on_.triangulate();
            const label first = on_.points().size();
            on_.points().append(far_.surface.points);
            faceList around(far_.surface.faces);
            for (face& f : around)
            {
                f = face(labelList(f + first));
            }
            on_.made.surface.faces.append(around);
            on_.made.surface.patchIDs.append(far_.surface.patchIDs);
        }

        removeUnusedPoints(on_.made.surface.faces, on_.made.surface.points);

        return on_.made;
    }
};

} // End anonymous namespace


farFieldBoundary makeFarFieldBoundary
(
    const prismLayers& layers,
    const farBoundary& boundary,
    const std::function<scalar(const point&)>& size
)
{
    return farFieldBoundaryMaker(layers, boundary, size).make();
}

} // End namespace Foam

// ************************************************************************* //
