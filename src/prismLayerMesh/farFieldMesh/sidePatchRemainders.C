/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatchRemainders.H"
#include "coarsenCuts.H"
#include "convexPolyhedron.H"
#include "edgeHashes.H"
#include "layerBorder.H"
#include "planePoints.H"
#include "planeTriangulation.H"
#include "readWallSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class farFieldBoundaryMaker
{
    const prismLayers& layers_;
    const farBoundary& far_;
    const std::function<scalar(const point&)>& size_;
    const List<sidePatch>& sides_;
    const boundBox box_;
    const scalar tolerance_;
    const layerBorder border_;

    farFieldBoundary made_;

    //- Region of each side patch
    List<planeRegion> regions_;

    //- Points of parts
    equalPoints labels_;

    pointField& points() { return made_.surface.points; }

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

    void addTriangle(const face& f, const label patchi)
    {
        made_.surface.faces.append(f);
        made_.surface.patchIDs.append(patchi);
    }

    //- The outer edges of the layers on side patches
    void addLayers();

    void addEdge(const label s, const edge& e);

    //- The outline of parts, beyond the layers
    void addParts();

    //- The far boundary, cut by the planes
    convexPolyhedron cutBoundary();

    void triangulate();

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
        layers_(layers),
        far_(far),
        size_(size),
        sides_(layers.border.sides),
        box_(boxOf(layers, far)),
        tolerance_(1e-9*box_.mag()),
        border_(layers, tolerance_),
        regions_(sides_.size())
    {
        made_.surface.patchNames = far.surface.patchNames;
        made_.surface.patchTypes = far.patchTypes;
        made_.firstSide = made_.surface.patchNames.size();
        for (const sidePatch& side : sides_)
        {
            made_.surface.patchNames.append(side.name);
            made_.surface.patchTypes.append(side.type);
        }
    }

    farFieldBoundary make();

    farFieldBoundary makeUpTo(const coreCut& cut);
};

void farFieldBoundaryMaker::addLayers()
{
    made_.columns = border_.columns();
    points() = border_.outerPoints();

    for (const point& top : points())
    {
        // The nearest point in the box is the point itself
        const point inBox(min(max(top, box_.min()), box_.max()));

        if (far_.surface.faces.size() && mag(top - inBox) > tolerance_)
        {
            FatalErrorInFunction
                << "The far boundary is not around the wall: the layers at "
                << top << " are outside of it" << exit(FatalError);
        }
    }

    forAll(border_.outerEdges(), i)
    {
        regions_[layers_.border.edgeSides[i]].boundary.append
        (
            border_.outerEdges()[i]
        );
    }
}


void farFieldBoundaryMaker::addEdge(const label s, const edge& e)
{
    const point& a = points()[e.start()];
    const point& b = points()[e.end()];
    regions_[s].boundary.append(e);

    // A plane ends there too, seen from the other side
    forAll(sides_, t)
    {
        if (!sides_[t].isPart() && sides_[t].hasEdge(a, b, tolerance_))
        {
            regions_[t].boundary.append(edge(e.end(), e.start()));
        }
    }
}


void farFieldBoundaryMaker::addParts()
{
    forAll(sides_, s)
    {
        for (const edge& e : outline(sides_[s].faces))
        {
            const point& a = sides_[s].points[e.start()];
            const point& b = sides_[s].points[e.end()];
            labelPair ends;

            const auto labelOf = [&](const label top, const point& x)
            {
                return top < 0 ? labels_.labelIn(points(), x) : top;
            };

            if (!border_.covers(a, b, ends))
            {
                addEdge
                (
                    s, edge(labelOf(ends.first(), a), labelOf(ends.second(), b))
                );
            }
        }
    }
}


convexPolyhedron farFieldBoundaryMaker::cutBoundary()
{
    const convexPolyhedron cut(cutBox(box_, sides_));
    const label first = points().size();
    points().append(cut.points);

    forAll(cut.faces, facei)
    {
        const label s = cut.planes[facei];
        const face f(labelList(cut.faces[facei] + first));

        for (label k = 0; s >= 0 && k < f.size(); ++k)
        {
            regions_[s].limits.append(f.faceEdge(k));
        }
    }

    return cut;
}


void farFieldBoundaryMaker::triangulate()
{
    forAll(sides_, s)
    {
        planeRegion& region = regions_[s];
        region.limits = dividedEdges
        (
            points(), region.limits, border_.outerPointsOn(s), tolerance_
        );
        region.normal = -sides_[s].normal;
        region.isCurved = sides_[s].isCurved();
        const pointField inside
        (
            planePoints(points(), region, sides_[s], size_)
        );
        region.points = identity(inside.size(), points().size());
        points().append(inside);

        for (const face& f : triangulatePlane(points(), region))
        {
            addTriangle(f, made_.firstSide + s);
        }
    }
}


void farFieldBoundaryMaker::addBoxSides
(
    const convexPolyhedron& cut,
    const label first
)
{
    edgeHashSet reached;
    for (const face& f : made_.surface.faces)
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
             || !std::any_of
                (
                    edges.begin(), edges.end(),
                    [&](const edge& e) { return reached.found(e); }
                )
            )
            {
                continue;
            }

            if (far_.surface.faces.empty())
            {
                FatalErrorInFunction
                    << "The fluid is open beyond the side planes at "
                    << f.centre(points()) << nl
                    << "Give the far field a boundary of type box"
                    << exit(FatalError);
            }

            for (label k = 1; k + 1 < f.size(); ++k)
            {
                addTriangle
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
    addLayers();
    addParts();
    coarsenCuts(points(), sides_, size_, regions_);

    if (hasPlanes(sides_))
    {
        if (far_.surface.faces.size() && far_.boxPatches.empty())
        {
            FatalErrorInFunction
                << "With side planes the far boundary has to be a box"
                << exit(FatalError);
        }

        const label first = points().size();
        const convexPolyhedron cut(cutBoundary());
        triangulate();
        addBoxSides(cut, first);
    }
    else
    {
        triangulate();
        const label first = points().size();
        points().append(far_.surface.points);
        forAll(far_.surface.faces, facei)
        {
            addTriangle
            (
                face(labelList(far_.surface.faces[facei] + first)),
                far_.surface.patchIDs[facei]
            );
        }
    }

    return made_;
}


farFieldBoundary farFieldBoundaryMaker::makeUpTo(const coreCut& cut)
{
    addLayers();
    const label first = points().size();
    points().append(cut.surface.points);
    forAll(sides_, s)
    {
        // Faces that are gone are to the left seen from outside
        for (const edge& e : cut.borders[s])
        {
            const edge reversed(e.end() + first, e.start() + first);
            regions_[s].boundary.append(reversed);
        }
        for (const edge& e : cut.limits[s])
        {
            regions_[s].limits.append(edge(e[0] + first, e[1] + first));
        }
    }
    triangulate();

    return made_;
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
    farFieldBoundary result
    (
        farFieldBoundaryMaker(layers, boundary, size).make()
    );
    removeUnusedPoints(result.surface.faces, result.surface.points);

    return result;
}


farFieldBoundary makePlaneRemainders
(
    const prismLayers& layers,
    const coreCut& cut,
    const std::function<scalar(const point&)>& size
)
{
    const farBoundary none;
    farFieldBoundaryMaker maker(layers, none, size);

    return maker.makeUpTo(cut);
}

} // End namespace Foam

// ************************************************************************* //
