/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farBoundary.H"
#include "disjointSets.H"
#include "error.H"
#include "farFieldMeshControls.H"
#include "labelledTriangle.H"
#include "ListOps.H"
#include "readWallSurface.H"
#include "refineSurface.H"
#include "treeBoundBox.H"
#include "wallDefects.H"
#include "wallSearch.H"

namespace Foam
{

//- Two triangles on each side, normals inwards
static wallSurface boxSurface(const boundBox& box)
{
    wallSurface surface;
    surface.points = treeBoundBox(box).points();
    surface.patchNames =
        wordList({"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"});
    forAll(surface.patchNames, side)
    {
        const face f(treeBoundBox::faces[side]);
        surface.faces.append(face({f[0], f[2], f[1]}));
        surface.faces.append(face({f[0], f[3], f[2]}));
        surface.patchIDs.append(labelList(2, side));
    }

    return surface;
}


//- The sides of a cube, refined and moved to the sphere
static wallSurface sphereSurface
(
    const point& origin,
    const scalar radius,
    const std::function<point(const point&)>& project
)
{
    const vector halfEdge(vector::one*radius/::sqrt(3.0));
    wallSurface surface
    (
        boxSurface(boundBox(origin - halfEdge, origin + halfEdge))
    );
    surface.patchIDs = 0;
    surface.patchNames = wordList({"sphere"});
    refineSurface
    (
        surface, [=](const point&) { return farFieldTuned.sphereEdge*radius; },
        project
    );

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

        boundary.project = [=](const point& x)
        {
            return origin + radius*normalised(x - origin);
        };
        boundary.surface = sphereSurface(origin, radius, boundary.project);
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
