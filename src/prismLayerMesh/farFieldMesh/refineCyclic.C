/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refineCyclic.H"
#include "boundBox.H"
#include "farFieldMeshControls.H"
#include "HashSet.H"
#include "ListOps.H"
#include "ranges.H"
#include "sidePair.H"
#include "stageProgress.H"
#include "surfacePart.H"

namespace Foam
{

namespace
{

//- A pair of patches of a surface
struct patchPair
{
    sidePair sides;

    word first;
    word second;

    //- For each point of the outline of the first patch, its image
    Map<label> images{};

    Map<label> originals{};

    void join(const label p, const label image)
    {
        images.insert(p, image);
        originals.insert(image, p);
    }
};


//- An edge, and where the points of its image are
struct edgeImage
{
    edge at;
    rigidMotion motion;
};

} // End anonymous namespace


//- The faces of the patches of a name
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


static labelList endsOf(const edgeList& edges)
{
    labelHashSet points;
    for (const edge& e : edges)
    {
        points.insert(e);
    }

    return points.sortedToc();
}


//- Joins the points of both outlines
static void joinOutlines(const wallSurface& surface, patchPair& pair)
{
    label lone;
    pair.images = imagesByLabel
    (
        endsOf(outlineOf(surface, pair.first)),
        endsOf(outlineOf(surface, pair.second)),
        [&](const label p) { return surface.points[p]; }, pair.sides.toSecond,
        1e-9*boundBox(surface.points, false).mag(), lone
    );
    if (lone >= 0)
    {
        FatalErrorInFunction
            << "The outlines of the cyclic patches " << pair.first << " and "
            << pair.second << " are no images of each other at "
            << surface.points[lone] << nl
            << "The wall must be the same on both" << exit(FatalError);
    }
    forAllConstIters(pair.images, iter)
    {
        pair.originals.insert(iter.val(), iter.key());
    }
}


//- The images of an edge of an outline on the other patches
static DynamicList<edgeImage> imagesOfEdge
(
    const UList<patchPair>& pairs,
    const edge& e
)
{
    DynamicList<edgeImage> all;
    const auto add = [&](const Map<label>& map, const rigidMotion& motion)
    {
        if (map.found(e.start()) && map.found(e.end()))
        {
            all.append
            (
                edgeImage{edge(map[e.start()], map[e.end()]), motion}
            );
        }
    };
    for (const patchPair& pair : pairs)
    {
        add(pair.images, pair.sides.toSecond);
        add(pair.originals, pair.sides.toSecond.inverse());
    }

    return all;
}


namespace
{

//- Divides the edges of outlines that are too long, and all of their images
struct outlineDivider
{
    wallSurface& surface;
    UList<patchPair>& pairs;
    const std::function<scalar(const point&)>& size;

    //- Edges with two faces
    edgeHashSet divisible{};

    //- Labels of the midpoints
    EdgeMap<label> middles{};
    DynamicList<point> points{};

    bool isLong(const edge& e) const
    {
        return e.mag(surface.points)
            > farFieldTuned.maxLength*size(e.centre(surface.points));
    }

    //- Divides an edge and its images
    void divide(const edge& e)
    {
        const auto add = [&](const edge& at, const point& x)
        {
            const bool isNew = middles.insert(at, points.size());
            if (isNew)
            {
                points.append(x);
            }

            return isNew;
        };

        DynamicList<edge> edges;
        if (add(e, e.centre(surface.points)))
        {
            edges.append(e);
        }
        for (label i = 0; i < edges.size(); ++i)
        {
            const point x(points[middles[edges[i]]]);
            for (const edgeImage& image : imagesOfEdge(pairs, edges[i]))
            {
                if (add(image.at, image.motion(x)))
                {
                    edges.append(image.at);
                }
            }
        }
    }

    //- The midpoints of images are images
    void joinMiddles()
    {
        for (patchPair& pair : pairs)
        {
            for (const edge& e : middles.sortedToc())
            {
                if (pair.images.found(e.start()) && pair.images.found(e.end()))
                {
                    const edge image
                    (
                        pair.images[e.start()], pair.images[e.end()]
                    );
                    if (middles.found(image))
                    {
                        pair.join(middles[e], middles[image]);
                    }
                }
            }
        }
    }

    //- Divides faces at their marked edges, one after the other
    void divideFaces()
    {
        DynamicList<face> faces(surface.faces);
        DynamicList<label> patchIDs(surface.patchIDs);
        for (label facei = 0; facei < faces.size(); ++facei)
        {
            for (label k = 0; k < 3; ++k)
            {
                const face f(faces[facei]);
                const edge e(f.faceEdge(k));
                if (middles.found(e))
                {
                    const label apex = f[(k + 2) % 3];
                    faces[facei] = face({e[0], middles[e], apex});
                    faces.append(face({middles[e], e[1], apex}));
                    patchIDs.append(label(patchIDs[facei]));
                    --facei;
                    break;
                }
            }
        }
        surface.faces.transfer(faces);
        surface.patchIDs.transfer(patchIDs);
    }

    //- False if no edge was too long
    bool divideOnce()
    {
        const edgeHashSet open(outline(surface.faces));
        middles.clear();
        points = surface.points;
        for (const patchPair& pair : pairs)
        {
            for (const word& name : {pair.first, pair.second})
            {
                for (const edge& e : outlineOf(surface, name))
                {
                    if (!open.found(e) && isLong(e))
                    {
                        divide(e);
                    }
                }
            }
        }
        if (middles.empty())
        {
            return false;
        }

        surface.points = points;
        joinMiddles();
        divideFaces();

        return true;
    }
};


//- Puts a surface together of parts that were refined
struct partRefiner
{
    const wallSurface& whole;
    const std::function<scalar(const point&)>& size;
    const std::function<point(const point&)>& project;

    wallSurface made{};

    //- Refines faces, and adds them. Returns the labels of the points of the
    //  part. The points of the outline come first.
    //  nOutline: set to the number of points of the outline
    labelList add(const labelUList& faces, label& nOutline)
    {
        const labelList ends(endsOf(outline(faceList(whole.faces, faces))));
        bitSet isInner
        (
            pointsOf(faceList(whole.faces, faces), whole.points.size())
        );
        isInner.unset(ends);
        labelList points(ends);
        points.append(isInner.toc());

        wallSurface part(partOf(whole, points, faces));
        refineSurface(part, size, project);
        part.patchNames.clear();
        part.patchTypes.clear();
        nOutline = ends.size();
        const label first = made.points.size();
        appendSurface(part, ends, made);

        labelList labels(ends);
        labels.append(identity(part.points.size() - nOutline, first));

        return labels;
    }
};

} // End anonymous namespace


//- Adds the images of the last faces
static void addImagesOfFaces
(
    const patchPair& pair,
    const label patchi,
    const label firstFace,
    const labelUList& points,
    const label nOutline,
    wallSurface& surface
)
{
    Map<label> images(pair.images);
    for (label i = nOutline; i < points.size(); ++i)
    {
        images.insert(points[i], surface.points.size());
        surface.points.append
        (
            pair.sides.toSecond(point(surface.points[points[i]]))
        );
    }
    const label nFaces = surface.faces.size() - firstFace;
    faceList faces(nFaces);
    forAll(faces, i)
    {
        const face& f = surface.faces[firstFace + i];
        faces[i] = face({images[f[0]], images[f[2]], images[f[1]]});
    }
    surface.faces.append(faces);
    surface.patchIDs.append(labelList(nFaces, patchi));
}


//- The smallest size at a point and its images on cyclic sides
static scalar smallestSize
(
    const std::function<scalar(const point&)>& size,
    const UList<sidePatch>& sides,
    const UList<patchPair>& pairs,
    const scalar tolerance,
    const point& x
)
{
    DynamicList<point> places({x});
    for (const patchPair& pair : pairs)
    {
        const label n = places.size();
        for (label i = 0; i < n; ++i)
        {
            const point at(places[i]);
            if (mag(sides[pair.sides.first].distance(at)) < tolerance)
            {
                places.append(pair.sides.toSecond(at));
            }
            if (mag(sides[pair.sides.second].distance(at)) < tolerance)
            {
                places.append(pair.sides.toSecond.inverse()(at));
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


//- The pairs of patches, with their outlines joined
static DynamicList<patchPair> joinedPairs
(
    const wallSurface& surface,
    const UList<sidePatch>& cyclicSides
)
{
    DynamicList<patchPair> pairs;
    for (const sidePair& sides : pairsOf(cyclicSides))
    {
        pairs.append
        (
            patchPair
            {
                sides, cyclicSides[sides.first].name,
                cyclicSides[sides.second].name
            }
        );
        joinOutlines(surface, pairs.last());
    }

    return pairs;
}


//- Refines the first patch of each pair, and the patches of no pair. The others
//  become images.
static wallSurface refinedByParts
(
    const wallSurface& surface,
    const UList<patchPair>& pairs,
    partRefiner& refiner
)
{
    wallSurface& made = refiner.made;
    made.points = surface.points;
    boolList isDone(surface.faces.size(), false);
    label nOutline;
    for (const patchPair& pair : pairs)
    {
        const labelList faces(facesOfPatch(surface, pair.first));
        const labelList images(facesOfPatch(surface, pair.second));
        if (faces.empty())
        {
            continue;
        }

        const label firstFace = made.faces.size();
        const labelList points(refiner.add(faces, nOutline));
        addImagesOfFaces
        (
            pair, surface.patchIDs[images[0]], firstFace, points, nOutline, made
        );
        UIndirectList<bool>(isDone, faces) = true;
        UIndirectList<bool>(isDone, images) = true;
    }
    refiner.add(findIndices(isDone, false), nOutline);
    removeUnusedPoints(made.faces, made.points);
    made.patchNames = surface.patchNames;
    made.patchTypes = surface.patchTypes;

    return std::move(made);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void refineCyclic
(
    wallSurface& surface,
    const UList<sidePatch>& cyclicSides,
    const std::function<scalar(const point&)>& size,
    const std::function<point(const point&)>& project
)
{
    if (cyclicSides.empty())
    {
        refineSurface(surface, size, project);
        return;
    }

    DynamicList<patchPair> pairs(joinedPairs(surface, cyclicSides));
    const scalar tolerance = 1e-9*boundBox(surface.points, false).mag();
    const std::function<scalar(const point&)> smallest = [&](const point& x)
    {
        return smallestSize(size, cyclicSides, pairs, tolerance, x);
    };
    repeatUntilStable
    (
        "dividing the outlines of cyclic patches", farFieldTuned.maxDivisions,
        [&]()
        {
            return outlineDivider{surface, pairs, smallest}.divideOnce();
        }
    );

    partRefiner refiner{surface, smallest, project};
    surface = refinedByParts(surface, pairs, refiner);
}

} // End namespace Foam

// ************************************************************************* //
