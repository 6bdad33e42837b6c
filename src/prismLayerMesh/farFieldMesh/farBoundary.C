/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farBoundary.H"
#include "farFieldMeshControls.H"
#include "readWallSurface.H"
#include "wallDefects.H"
#include "error.H"
#include "labelVector.H"
#include "ListOps.H"
#include "Map.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
    label pointLabel(const labelVector& at);

    void addSide(label side);
};


label boxSquares::pointLabel(const labelVector& at)
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


void boxSquares::addSide(const label side)
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

} // End namespace Foam

// ************************************************************************* //
