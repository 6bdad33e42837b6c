/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatchRemainders.H"
#include "coarsenCuts.H"
#include "convexPolyhedron.H"
#include "edgeHashes.H"
#include "ranges.H"
#include "surfacePart.H"
#include "sideRegions.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
            box = boundBox(layers.points, false);
            box.inflate(1);
        }
        return box;
    }

    //- Refuses layers outside of the far boundary
    void checkInBox() const;

    void addEdge(const label s, const edge& e);

    //- The outline of parts, beyond the layers
    void addParts();

    //- The far boundary, cut by the planes
    convexPolyhedron cutBoundary();

    //- The sides of the box that the far field reaches
    void addBoxSides(const convexPolyhedron& cut, label first);

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

    farFieldBoundary make();
};


void farFieldBoundaryMaker::checkInBox() const
{
    for (const point& top : on_.border.outerPoints())
    {
        // The nearest point in the box is the point itself
        const point inBox(min(max(top, box_.min()), box_.max()));

        if (far_.surface.faces.size() && mag(top - inBox) > on_.tolerance)
        {
            FatalErrorInFunction
                << "The far boundary is not around the wall: the layers at "
                << top << " are outside of it" << exit(FatalError);
        }
    }
}


void farFieldBoundaryMaker::addEdge(const label s, const edge& e)
{
    const point& a = on_.points()[e.start()];
    const point& b = on_.points()[e.end()];
    on_.regions[s].boundary.append(e);

    // A plane ends there too, seen from the other side
    forAll(on_.sides, t)
    {
        if (!on_.sides[t].isPart() && on_.sides[t].hasEdge(a, b, on_.tolerance))
        {
            on_.regions[t].boundary.append(edge(e.end(), e.start()));
        }
    }
}


void farFieldBoundaryMaker::addParts()
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


convexPolyhedron farFieldBoundaryMaker::cutBoundary()
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


void farFieldBoundaryMaker::addBoxSides
(
    const convexPolyhedron& cut,
    const label first
)
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
                    << "Give the far field a boundary of type box"
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


farFieldBoundary farFieldBoundaryMaker::make()
{
    checkInBox();
    addParts();
    coarsenCuts(on_.points(), on_.sides, on_.size, on_.regions);

    if (hasPlanes(on_.sides))
    {
        if (far_.surface.faces.size() && far_.boxPatches.empty())
        {
            FatalErrorInFunction
                << "With side planes the far boundary has to be a box"
                << exit(FatalError);
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
        forAll(far_.surface.faces, facei)
        {
            on_.addTriangle
            (
                face(labelList(far_.surface.faces[facei] + first)),
                far_.surface.patchIDs[facei]
            );
        }
    }

    removeUnusedPoints(on_.made.surface.faces, on_.made.surface.points);

    return on_.made;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
