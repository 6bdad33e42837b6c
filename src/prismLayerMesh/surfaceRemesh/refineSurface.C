/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refineSurface.H"
#include "boundBox.H"
#include "DynamicField.H"
#include "EdgeMap.H"
#include "equalPoints.H"
#include "HashSet.H"
#include "ListOps.H"
#include "remesher.H"
#include "sidePair.H"

#include <vector>

namespace Foam
{

//- The length of an edge that is kept is a floor on the sizes near it. The
//  floor falls by this share of the distance from the edge: so slowly that in
//  each triangle on the edge that is divided another edge is longer.
static constexpr scalar keptSlope = 0.25;

//- The length that edges want over the size: the remesher splits edges at 4/3
//  of the length, and collapses them at 4/5
static constexpr scalar wantedShare = 0.94;

//- Edges of the outlines of cyclic patches are divided if they are longer than
//  this share of the size
static constexpr scalar longestOnOutline = 4.0/3.0;

//- Largest angle [degrees] between triangles that are in a plane, and largest
//  distance from the plane over the diagonal of the surface
static constexpr scalar flatAngle = 1e-3;
static constexpr scalar flatness = 1e-9;

//- Largest distance of new triangles from those of a smooth surface over the
//  diagonal
static constexpr scalar smoothness = 0.03;

//- Images are so near to a point, over the diagonal of the surface
static constexpr scalar imageTolerance = 1e-9;


namespace
{

//- The images of a cyclic patch on the other one of its pair
struct cyclicImages
{
    const sidePatch& from;
    const sidePatch& to;
    rigidMotion motion;

    //- For each point of the outline its image
    Map<label> images;

    //- The image of an edge of the outline; labels of -1 if there is none
    edge operator()(const edge& e) const
    {
        return edge(images.lookup(e[0], -1), images.lookup(e[1], -1));
    }
};

} // End anonymous namespace


static scalar diagonal(const wallSurface& surface)
{
    return boundBox(surface.points, false).mag();
}


static labelList facesOfPatch(const wallSurface& surface, const word& name)
{
    return subsetList
    (
        identity(surface.faces.size()), [&](const label facei)
        {
            return surface.patchNames[surface.patchIDs[facei]] == name;
        }
    );
}


//- The edges of a patch that it has with other patches, or that have one face
static edgeList outlineOf(const wallSurface& surface, const word& name)
{
    return outline(faceList(surface.faces, facesOfPatch(surface, name)));
}


static Map<label> joinedOutlines
(
    const wallSurface& surface,
    const word& from,
    const word& to,
    const rigidMotion& motion
)
{
    const auto pointsOf = [&](const word& name)
    {
        labelHashSet points;
        for (const edge& e : outlineOf(surface, name))
        {
            points.insert(e);
        }

        return points.sortedToc();
    };

    label lone;
    const Map<label> images = imagesByLabel
    (
        pointsOf(from), pointsOf(to),
        [&](const label p) { return surface.points[p]; }, motion,
        imageTolerance*diagonal(surface), lone
    );
    if (lone >= 0)
    {
        FatalErrorInFunction
            << "The outlines of the cyclic patches " << from << " and " << to
            << " are no images of each other at " << surface.points[lone] << nl
            << "The wall must be the same on both" << exit(FatalError);
    }

    return images;
}


//- From the first patch of each pair to the second one, and back
static std::vector<cyclicImages> imagesOf
(
    const wallSurface& surface,
    const UList<sidePatch>& sides
)
{
    std::vector<cyclicImages> all;
    for (const sidePair& pair : pairsOf(sides))
    {
        const sidePatch& first = sides[pair.first];
        const sidePatch& second = sides[pair.second];
        const Map<label> images
        (
            joinedOutlines(surface, first.name, second.name, pair.toSecond)
        );
        Map<label> originals;
        forAllConstIters(images, iter)
        {
            originals.insert(iter.val(), iter.key());
        }
        all.push_back(cyclicImages{first, second, pair.toSecond, images});
        all.push_back
        (
            cyclicImages{second, first, pair.toSecond.inverse(), originals}
        );
    }

    return all;
}


//- The smallest size at a point and its images
static scalar smallestSize
(
    const std::function<scalar(const point&)>& size,
    const std::vector<cyclicImages>& cyclic,
    const scalar tolerance,
    const point& x
)
{
    DynamicList<point> places({x});
    for (const cyclicImages& images : cyclic)
    {
        for (label i = places.size() - 1; i >= 0; --i)
        {
            const point at(places[i]);
            if (mag(images.from.distance(at)) < tolerance)
            {
                places.append(images.motion(at));
            }
        }
    }

    scalar smallest = GREAT;
    for (const point& at : places)
    {
        smallest = min(smallest, size(at));
    }

    return smallest;
}


//- Splits an edge of outlines in the middle, and its images
static void splitWithImages
(
    editedSurface& edited,
    std::vector<cyclicImages>& cyclic,
    const edge& first
)
{
    typedef editedSurface::Vertex Vertex;
    const auto& mesh = edited.mesh();
    const auto at = [&](const label p) { return edited.at(Vertex(p)); };
    DynamicList<edge> edges({first});
    DynamicList<point> places({0.5*(at(first[0]) + at(first[1]))});
    EdgeMap<label> middles;
    for (label i = 0; i < edges.size(); ++i)
    {
        const edge e(edges[i]);
        const point x(places[i]);
        const auto h =
            e[0] < 0 || e[1] < 0
          ? mesh.null_halfedge() : mesh.halfedge(Vertex(e[0]), Vertex(e[1]));
        if (h == mesh.null_halfedge())
        {
            continue;
        }

        middles.insert(e, mesh.num_vertices());
        edited.split(mesh.edge(h), x, edited.line(mesh.edge(h)));
        for (const cyclicImages& images : cyclic)
        {
            edges.append(images(e));
            places.append(images.motion(x));
        }
    }

    for (cyclicImages& images : cyclic)
    {
        for (const edge& e : middles.sortedToc())
        {
            if (middles.found(images(e)))
            {
                images.images.insert(middles[e], middles[images(e)]);
            }
        }
    }
}


//- Divides the edges on the outlines of cyclic patches, except open edges
static void divideOutlines
(
    editedSurface& edited,
    const edgeHashSet& open,
    const std::function<scalar(const point&)>& size,
    std::vector<cyclicImages>& cyclic
)
{
    const auto& mesh = edited.mesh();
    const auto isLong = [&](const editedSurface::Edge e)
    {
        const label line = edited.line(e);
        const point x
        (
            0.5*(edited.at(mesh.vertex(e, 0)) + edited.at(mesh.vertex(e, 1)))
        );

        return
            line >= 0 && edited.isKept(e)
         && !open.found(edited.given().lines()[line])
         && edited.length(e) > longestOnOutline*size(x);
    };

    // New edges come last
    for (unsigned i = 0; i < mesh.num_edges(); ++i)
    {
        const editedSurface::Edge e(i);
        while (isLong(e))
        {
            const edge ends(mesh.vertex(e, 0), mesh.vertex(e, 1));
            splitWithImages(edited, cyclic, ends);
        }
    }
}


//- Sets the lengths to the sizes, and not below the floors of kept edges
static void setSizes
(
    editedSurface& edited,
    const std::function<scalar(const point&)>& size
)
{
    const auto& mesh = edited.mesh();
    scalarField floors(mesh.num_vertices(), 0);
    for (const auto e : mesh.edges())
    {
        if (edited.isKept(e))
        {
            for (const label p : {mesh.vertex(e, 0), mesh.vertex(e, 1)})
            {
                floors[p] = max(floors[p], edited.length(e));
            }
        }
    }

    for (bool more = true; more;)
    {
        more = false;
        for (const auto e : mesh.edges())
        {
            const scalar fall = keptSlope*edited.length(e);
            scalar& a = floors[label(mesh.vertex(e, 0))];
            scalar& b = floors[label(mesh.vertex(e, 1))];
            more = more || a < b - fall || b < a - fall;
            a = max(a, b - fall);
            b = max(b, a - fall);
        }
    }

    for (const auto v : mesh.vertices())
    {
        edited.lengths[v] =
            max(wantedShare*size(edited.at(v)), floors[label(v)]);
    }
}


// * * * * * * * * * * * * * * * * Join Images * * * * * * * * * * * * * * * //

namespace
{

//- A surface put together of triangles; points by their places
struct joinedSurface
{
    DynamicField<point> points;
    DynamicList<face> faces{};
    DynamicList<label> patchIDs{};
    equalPoints labels{};

    //- Begins with points that keep their labels
    explicit joinedSurface(const UList<point>& kept)
    :
        points(kept)
    {
        forAll(points, p)
        {
            labels.insert(points[p], p);
        }
    }

    label labelOf(const point& x)
    {
        if (labels.insert(x, points.size()))
        {
            points.append(x);
        }

        return labels.find(x);
    }

    void add(const point& a, const point& b, const point& c, const label patchi)
    {
        faces.append(face({labelOf(a), labelOf(b), labelOf(c)}));
        patchIDs.append(patchi);
    }
};

} // End anonymous namespace


//- Replaces a surface by new triangles and, on the second patch of each pair,
//  images of these.
//  outlines: the points of outlines
static void joinImages
(
    const wallSurface& made,
    const std::vector<cyclicImages>& cyclic,
    const pointField& outlines,
    const label nKept,
    wallSurface& surface
)
{
    joinedSurface joined{SubList<point>(surface.points, nKept)};
    const auto at = [&](const label facei, const label k)
    {
        return made.points[made.faces[facei][k]];
    };
    forAll(made.faces, facei)
    {
        joined.add
        (
            at(facei, 0), at(facei, 1), at(facei, 2), made.patchIDs[facei]
        );
    }

    equalPoints onOutlines;
    forAll(outlines, p)
    {
        onOutlines.insert(outlines[p], p);
    }
    for (std::size_t i = 0; i < cyclic.size(); i += 2)
    {
        const cyclicImages& images = cyclic[i];
        const labelList second(facesOfPatch(surface, images.to.name));
        const auto imageOf = [&](const point& x)
        {
            const label p = images.images.lookup(onOutlines.find(x), -1);

            return p < 0 ? images.motion(x) : outlines[p];
        };
        for (const label facei : facesOfPatch(made, images.from.name))
        {
            joined.add
            (
                imageOf(at(facei, 0)), imageOf(at(facei, 2)),
                imageOf(at(facei, 1)), surface.patchIDs[second[0]]
            );
        }
    }

    surface.points.transfer(joined.points);
    surface.faces.transfer(joined.faces);
    surface.patchIDs.transfer(joined.patchIDs);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void refineSurface
(
    wallSurface& surface,
    const std::function<scalar(const point&)>& size,
    const std::function<point(const point&)>& project,
    const UList<sidePatch>& cyclicSides,
    const label nKept
)
{
    std::vector<cyclicImages> cyclic(imagesOf(surface, cyclicSides));
    const edgeHashSet open(outline(surface.faces));
    edgeHashSet kept(open);
    bitSet isImage(surface.faces.size());
    for (std::size_t i = 0; i < cyclic.size(); i += 2)
    {
        kept.insert(outlineOf(surface, cyclic[i].from.name));
        kept.insert(outlineOf(surface, cyclic[i].to.name));
        isImage.set(facesOfPatch(surface, cyclic[i].to.name));
    }
    wallSurface first(surface);
    isImage.flip();
    first.faces = subset(isImage, surface.faces);
    first.patchIDs = subset(isImage, surface.patchIDs);

    const scalar length = diagonal(surface);
    const std::function<scalar(const point&)> smallest = [&](const point& x)
    {
        return smallestSize(size, cyclic, imageTolerance*length, x);
    };
    const givenSurface given
    (
        first, project ? 180 : flatAngle,
        (project ? smoothness : flatness)*length
    );
    editedSurface edited(given, false, kept);
    divideOutlines(edited, open, smallest, cyclic);
    const pointField outlines(edited.surface().points);
    remesher
    (
        edited, [&](editedSurface& made) { setSizes(made, smallest); }
    ).remesh();

    joinImages(edited.surface(), cyclic, outlines, nKept, surface);
    if (project)
    {
        for (point& x : surface.points)
        {
            x = project(x);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
