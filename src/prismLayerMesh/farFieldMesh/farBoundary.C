/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "farBoundary.H"
#include "readWallSurface.H"
#include "wallDefects.H"
#include "error.H"
#include "labelVector.H"
#include "Map.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- On an edge of a box, at most
static const label maxSquares = 100;


//- Sides of squares, as nearly as these fit, of two triangles each; normals
//  inwards
static wallSurface boxSurface(const boundBox& box)
{
    const vector span(box.span());
    labelVector n;
    for (direction d = 0; d < 3; ++d)
    {
        n[d] = min(label(span[d]/cmptMin(span) + 0.5), maxSquares);
    }

    wallSurface surface;
    surface.patchNames =
        wordList({"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"});

    DynamicList<point> points;
    DynamicList<face> faces;
    DynamicList<label> patchIDs;
    Map<label> labels;

    // The point at these counts of squares
    const auto pointLabel = [&](const labelVector& at)
    {
        const label key =
            at.x() + (maxSquares + 1)*(at.y() + (maxSquares + 1)*at.z());

        if (labels.insert(key, points.size()))
        {
            point x;
            for (direction d = 0; d < 3; ++d)
            {
                x[d] = at[d] == n[d]
                  ? box.max()[d] : box.min()[d] + span[d]*at[d]/n[d];
            }
            points.append(x);
        }

        return labels[key];
    };

    for (label side = 0; side < 6; ++side)
    {
        const direction d = side/2;
        const direction e = (d + 1) % 3;
        const direction f = (d + 2) % 3;
        labelVector at(Zero);
        at[d] = side % 2 ? n[d] : 0;

        for (label i = 0; i < n[e]; ++i)
        {
            for (label j = 0; j < n[f]; ++j)
            {
                const auto corner = [&](const label k, const label l)
                {
                    at[e] = i + k;
                    at[f] = j + l;
                    return pointLabel(at);
                };
                face square
                ({
                    corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)
                });

                if (side % 2)
                {
                    square.flip();
                }

                faces.append(face({square[0], square[1], square[2]}));
                faces.append(face({square[0], square[2], square[3]}));
                patchIDs.append(side);
                patchIDs.append(side);
            }
        }
    }

    surface.points.transfer(points);
    surface.faces.transfer(faces);
    surface.patchIDs.transfer(patchIDs);

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
    asWall.file = controls.file;
    asWall.fluidOutside = false;
    asWall.scale = controls.scale;

    wallReading reading;
    wallSurface surface
    (
        readWallSurface(file(controls.file), asWall, reading)
    );
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


//- Names and types of the patches in place of the sides
static void setPatches(const List<farPatch>& patches, farBoundary& boundary)
{
    const wordList sides(boundary.surface.patchNames);
    labelList patchOf(sides.size(), -1);
    DynamicList<word> names;
    DynamicList<word> types;

    for (const farPatch& patch : patches)
    {
        bool used = false;

        forAll(sides, side)
        {
            if (patch.sides.match(sides[side]))
            {
                patchOf[side] = names.size();
                used = true;
            }
        }

        if (!used)
        {
            FatalErrorInFunction
                << "The patch " << patch.name << " of the far boundary has no"
                << " sides: none is called " << patch.sides << nl
                << "Sides: " << sides << exit(FatalError);
        }

        names.append(patch.name);
        types.append(patch.type);
    }

    forAll(sides, side)
    {
        if (patchOf[side] < 0)
        {
            if (names.found(sides[side]))
            {
                FatalErrorInFunction
                    << "The side " << sides[side] << " of the far boundary"
                    << " has the name of a patch that it is not part of"
                    << exit(FatalError);
            }

            patchOf[side] = names.size();
            names.append(sides[side]);
            types.append("patch");
        }
    }

    for (label& patchi : boundary.surface.patchIDs)
    {
        patchi = patchOf[patchi];
    }

    boundary.surface.patchNames.transfer(names);
    boundary.patchTypes.transfer(types);
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::farBoundary Foam::makeFarBoundary
(
    const farBoundaryControls& controls,
    const std::function<fileName(const fileName&)>& file
)
{
    farBoundary boundary;

    if (controls.type == "box")
    {
        boundary.surface = boxSurface(controls.box);
    }
    else if (controls.type == "sphere")
    {
        const point origin(controls.origin);
        const scalar radius = controls.radius;

        boundary.surface = sphereSurface(origin, radius);
        boundary.project = [=](const point& x)
        {
            return origin + radius*normalised(x - origin);
        };
    }
    else if (controls.type == "surface")
    {
        boundary.surface = readSurface(controls, file);
    }

    setPatches(controls.patches, boundary);

    return boundary;
}


// ************************************************************************* //
