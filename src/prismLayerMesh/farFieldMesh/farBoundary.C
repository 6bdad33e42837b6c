/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farBoundary.H"
#include "disjointSets.H"
#include "error.H"
#include "farFieldMeshControls.H"
#include "labelledTriangle.H"
#include "labelVector.H"
#include "ListOps.H"
#include "Map.H"
#include "readWallSurface.H"
#include "wallDefects.H"
#include "wallSearch.H"

namespace Foam
{

namespace
{

//- Squares on the sides of a box
struct boxSquares
{
    const boundBox& box;

    //- Squares along each edge
    labelVector n;

    DynamicList<point> points;
    DynamicList<face> faces;

    //- The labels of points, by their counts of squares
    Map<label> labels;

    //- The point at the given counts of squares
    label pointLabel(const labelVector& at)
    {
        const label m = farFieldTuned.maxSquares + 1;
        const label key = at.x() + m*(at.y() + m*at.z());

        if (labels.insert(key, points.size()))
        {
            point x(box.max());
            for (direction d = 0; d < 3; ++d)
            {
                if (at[d] < n[d])
                {
                    x[d] = box.min()[d] + box.span()[d]*at[d]/n[d];
                }
            }
            points.append(x);
        }

        return labels[key];
    }

    void addSide(const label side)
    {
        const direction d = side/2;
        const direction e = (d + 1) % 3;
        const direction f = (d + 2) % 3;
        labelVector at(Zero);
        at[d] = side % 2 ? n[d] : 0;

        const auto corner = [&](const label i, const label j)
        {
            at[e] = i;
            at[f] = j;
            return pointLabel(at);
        };

        for (label i = 0; i < n[e]; ++i)
        {
            for (label j = 0; j < n[f]; ++j)
            {
                face square
                ({
                    corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                    corner(i, j + 1)
                });

                if (side % 2)
                {
                    square.flip();
                }

                faces.append(face({square[0], square[1], square[2]}));
                faces.append(face({square[0], square[2], square[3]}));
            }
        }
    }
};

} // End anonymous namespace


//- Squares, as nearly as they fit the sides, of two triangles each; normals
//  inwards
static wallSurface boxSurface(const boundBox& box)
{
    const vector span(box.span());
    boxSquares squares{box, labelVector(), {}, {}, {}};
    for (direction d = 0; d < 3; ++d)
    {
        const label n = span[d]/cmptMin(span) + 0.5;
        squares.n[d] = min(n, farFieldTuned.maxSquares);
    }

    wallSurface surface;
    surface.patchNames =
        wordList({"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"});
    for (label side = 0; side < 6; ++side)
    {
        squares.addSide(side);
        surface.patchIDs.setSize(squares.faces.size(), side);
    }
    surface.points.transfer(squares.points);
    surface.faces.transfer(squares.faces);

    return surface;
}


//- An octahedron, normals inwards
static wallSurface sphereSurface(const point& origin, const scalar radius)
{
    wallSurface surface;
    surface.points.setSize(6);
    for (direction d = 0; d < 3; ++d)
    {
        vector axis(Zero);
        axis[d] = radius;
        surface.points[2*d] = origin - axis;
        surface.points[2*d + 1] = origin + axis;
    }

    DynamicList<face> faces;
    for (label octant = 0; octant < 8; ++octant)
    {
        const label a = octant & 1;
        const label b = 2 + (octant >> 1 & 1);
        const label c = 4 + (octant >> 2 & 1);
        const bool odd = (a + b + c) & 1;
        faces.append(odd ? face({a, c, b}) : face({a, b, c}));
    }

    surface.faces.transfer(faces);
    surface.patchIDs = labelList(8, Zero);
    surface.patchNames = wordList({"sphere"});

    return surface;
}


static wallSurface readSurface
(
    const farBoundaryControls& controls,
    const std::function<fileName(const fileName&)>& file
)
{
    wallSurfaceControls asWall;
    asWall.files = fileNameList(1, controls.file);
    asWall.fluidOutside = false;
    asWall.scale = controls.scale;

    wallReading reading;
    const fileNameList files(1, file(controls.file));
    wallSurface surface(readWallSurface(files, asWall, reading));
    const List<wallDefect> defects(findWallDefects(surface));

    if (defects.size())
    {
        FatalErrorInFunction
            << "The surface " << controls.file << " cannot be the far boundary."
            << nl << describe(defects).c_str() << exit(FatalError);
    }

    labelList triangleFace;
    const faceList triangles(wallTriangles(surface, triangleFace));
    surface.patchIDs = UIndirectList<label>(surface.patchIDs, triangleFace)();
    surface.faces = triangles;

    return surface;
}


//- Gives the faces their patches, which replace the sides, in the order of the
//  patches that are wanted and then of the sides that none of these has
static void setPatches(const List<farPatch>& wanted, farBoundary& boundary)
{
    const wordList sides(boundary.surface.patchNames);
    labelList patchOf(sides.size(), -1);
    DynamicList<word> names;
    DynamicList<word> types;
    for (const farPatch& patch : wanted)
    {
        const labelList matching(patch.sides.matching(sides));
        UIndirectList<label>(patchOf, matching) = names.size();

        if (matching.empty())
        {
            FatalErrorInFunction
                << "The patch " << patch.name << " of the far boundary has no"
                << " sides: none is called " << patch.sides << nl
                << "Sides: " << sides << exit(FatalError);
        }

        names.append(patch.name);
        types.append(patch.type);
    }

    forAll(wanted, i)
    {
        if (!patchOf.found(i))
        {
            FatalErrorInFunction
                << "The patch " << wanted[i].name << " of the far boundary has"
                << " no sides: later patches take all of "
                << wanted[i].sides << nl
                << "A side belongs to the last patch that names it."
                << exit(FatalError);
        }
    }

    for (const label side : findIndices(patchOf, -1))
    {
        if (names.found(sides[side]))
        {
            FatalErrorInFunction
                << "The side " << sides[side] << " of the far boundary"
                << " is not in the patch of the same name. Rename the patch"
                << exit(FatalError);
        }

        patchOf[side] = names.size();
        names.append(sides[side]);
        types.append("patch");
    }

    inplaceRenumber(patchOf, boundary.surface.patchIDs);
    boundary.boxPatches.transfer(patchOf);
    boundary.surface.patchNames.transfer(names);
    boundary.patchTypes.transfer(types);
}


farBoundary makeFarBoundary
(
    const farBoundaryControls& controls,
    const std::function<fileName(const fileName&)>& file
)
{
    farBoundary boundary;

    if (controls.type == farBoundaryType::box)
    {
        boundary.surface = boxSurface(controls.box);
    }
    else if (controls.type == farBoundaryType::sphere)
    {
        const point origin(controls.origin);
        const scalar radius = controls.radius;

        boundary.surface = sphereSurface(origin, radius);
        boundary.project = [=](const point& x)
        {
            return origin + radius*normalised(x - origin);
        };
    }
    else if (controls.type == farBoundaryType::surface)
    {
        boundary.surface = readSurface(controls, file);
    }

    setPatches(controls.patches, boundary);
    if (controls.type != farBoundaryType::box)
    {
        boundary.boxPatches.clear();
    }

    return boundary;
}


farBoundary makeFarBoundary(const wallSurface& triangles)
{
    farBoundary boundary;
    boundary.surface = triangles;
    boundary.surface.patchTypes.clear();
    boundary.patchTypes = triangles.patchTypes;

    return boundary;
}


// * * * * * * * * * * * * *  Check Far Boundary * * * * * * * * * * * * * * //

//- Sets to false what is said of the bodies of faces that are inside of a solid
//  body. solids and cavities: a face of each of these bodies.
static void removeEnclosed
(
    const wallSurface& outer,
    const labelUList& solids,
    const labelUList& cavities,
    disjointSets& bodyOf,
    bitSet& isAround
)
{
    if (cavities.empty())
    {
        return;
    }

    for (const label solid : solids)
    {
        const label body = bodyOf.find(outer.faces[solid][0]);
        wallSurface one(outer);
        one.faces = subsetList
        (
            outer.faces,
            [&](const face& f) { return bodyOf.find(f[0]) == body; }
        );
        const wallSearch search(one);

        for (const label facei : cavities)
        {
            const face& f = outer.faces[facei];
            if (!search.inFront(f.centre(outer.points)))
            {
                isAround.unset(bodyOf.find(f[0]));
            }
        }
    }
}


//- Whether each triangle of the outer surface of the layers is of a body that
//  is around the fluid: the body is not closed, or its normals point inwards,
//  and it is no cavity of another body
static boolList aroundFluid(const wallSurface& outer)
{
    disjointSets bodyOf(connectedPoints(outer.points.size(), outer.faces));
    scalarField volumes(outer.points.size(), 0);
    for (const face& f : outer.faces)
    {
        const label body = bodyOf.find(f[0]);
        volumes[body] += (outer.points[f[0]] - outer.points[body])
          & f.areaNormal(outer.points);
    }
    bitSet isAround(outer.points.size());
    for (const edge& e : outline(outer.faces))
    {
        isAround.set(bodyOf.find(e.start()));
    }

    DynamicList<label> solids, inward;
    for (const label facei : largestFaces(outer))
    {
        const label body = bodyOf.find(outer.faces[facei][0]);
        if (!isAround.test(body))
        {
            (volumes[body] < 0 ? inward : solids).append(facei);
        }
    }
    for (const label facei : inward)
    {
        isAround.set(bodyOf.find(outer.faces[facei][0]));
    }
    removeEnclosed(outer, solids, inward, bodyOf, isAround);

    boolList result(outer.faces.size());
    forAll(result, i)
    {
        result[i] = isAround.test(bodyOf.find(outer.faces[i][0]));
    }

    return result;
}


void checkFarBoundary(const wallSurface& both, const label nOuter)
{
    const label nFar = both.faces.size() - nOuter;
    const auto triangles = [&](const label start, const label n)
    {
        return labelledTriangles
        (
            SubList<face>(both.faces, n, start), both.points, identity(n, start)
        );
    };

    DynamicList<labelPair> pairs;
    addIntersections(triangles(nOuter, nFar), triangles(0, nOuter), pairs);

    if (pairs.size())
    {
        const face& f = both.faces[pairs[0].second()];

        FatalErrorInFunction
            << "The far boundary cuts "
            << (pairs[0].first() < nOuter ? "the layers" : "itself") << " at "
            << pairs.size() << " places, first at "
            << f.centre(both.points) << nl
            << "Move farField.boundary away from the wall, or make the layers"
            << " thinner"
            << exit(FatalError);
    }

    const edgeList open(outline(both.faces));
    if (open.size())
    {
        FatalErrorInFunction
            << "The far boundary is not around the wall: it is open at "
            << open[0].centre(both.points) << nl
            << "Enlarge farField.boundary. Or, if the fluid is inside of the"
            << " wall, write surface { fluid inside; } and no boundary"
            << exit(FatalError);
    }

    checkBodies(both, nOuter);
}


void checkBodies(const wallSurface& both, const label nOuter)
{
    wallSurface outer(both);
    outer.faces.setSize(nOuter);
    const boolList isAround(aroundFluid(outer));
    wallSurface around(both);
    around.faces = subset(isAround, outer.faces);
    around.faces.append
    (
        SubList<face>(both.faces, both.faces.size() - nOuter, nOuter)
    );
    if (around.faces.empty())
    {
        return;
    }

    const wallSearch search(around);
    for (const label facei : largestFaces(outer))
    {
        const point x(outer.faces[facei].centre(both.points));

        if (!isAround[facei] && !search.inFront(x))
        {
            FatalErrorInFunction
                << "The far boundary is not around the wall: the body at " << x
                << " is outside of the fluid, whose boundary is "
                << search.footOf(x).distance << " m from it" << nl
                << "Enlarge farField.boundary, or remove the body from the"
                << " surface" << exit(FatalError);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
