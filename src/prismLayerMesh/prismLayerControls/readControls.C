/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readControls.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * *  Parts of Space * * * * * * * * * * * * * * //

void declareRegion
(
    controlEntries& entries,
    const keyType& name,
    geometryRegion& region
)
{
    region.name = name;
    if
    (
        entries.has
        (
            "geometry", "A searchableSurface of OpenFOAM", "dictionary"
        )
    )
    {
        region.geometry = optionalDict(*entries.dict(), "geometry");
    }
    static const wordList modes({"inside", "outside", "distance"});
    entries.readChoice
    (
        "mode", region.mode, modes,
        "Side of the geometry on which the region is"
    );
    const bool hasDistance = entries.readBounded
    (
        "distance", region.distance, SMALL, GREAT,
        "Width of a region of mode distance [m]"
    );

    const dictionary* dict = entries.dict();
    if (dict)
    {
        mandatoryDict(*dict, "geometry");
    }
    if (dict && hasDistance != (region.mode == geometryRegion::modes::distance))
    {
        entryError(*dict, hasDistance ? "distance" : "mode")
            << "The region " << region.name << " has mode "
            << modes[int(region.mode)]
            << (hasDistance ? " with a distance" : " without a distance")
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * * Remesh  * * * * * * * * * * * * * * * * //

//- The longest edge in a part of the surface, no shorter than the shortest
static void declareMaxEdge
(
    controlEntries& entries,
    const surfaceRemeshControls& general,
    scalar& maxEdge
)
{
    entries.readBounded
    (
        "maxEdge", maxEdge, max(general.minEdge, SMALL), GREAT,
        "Length of edges there, at most, and at least minEdge [m]"
    );
    entries.require("maxEdge");
}


static void declareParts
(
    controlEntries& entries,
    surfaceRemeshControls& controls
)
{
    entries.readDicts
    (
        "patches", controls.patches, "Edges on patches",
        [&](controlEntries& part, const keyType& key, patchEdges& patch)
        {
            patch.patches = key;
            declareMaxEdge(part, controls, patch.maxEdge);
        }
    );
    entries.readDicts
    (
        "regions", controls.regions, "Edges in parts of space",
        [&](controlEntries& part, const keyType& key, edgeRegion& region)
        {
            declareRegion(part, key, region);
            declareMaxEdge(part, controls, region.maxEdge);
        }
    );
    entries.readDict
    (
        "sharpEdges", "Edges on sharp edges", [&](controlEntries& sharp)
        {
            scalar& angle = controls.sharpAngle;
            angle = max(angle, controls.featureAngle);
            sharp.readBounded
            (
                "angle", angle, controls.featureAngle, 180,
                "Least angle of a sharp edge, at least featureAngle [deg]"
            );
            declareMaxEdge(sharp, controls, controls.sharpMaxEdge);
        }
    );
}


void declare(controlEntries& entries, surfaceRemeshControls& controls)
{
    entries.readBounded
    (
        "maxEdge", controls.maxEdge, SMALL, GREAT,
        "Length of edges, at most [m]", "0.02 of the diagonal"
    );
    entries.readBounded
    (
        "minEdge", controls.minEdge, SMALL,
        controls.maxEdge > 0 ? controls.maxEdge : GREAT,
        "Length of edges, at least [m]", "0.02 of maxEdge"
    );
    entries.readBounded
    (
        "deviation", controls.deviation, SMALL, GREAT,
        "Distance from the given surface, at most [m]", "5e-4 of the diagonal"
    );
    entries.readBounded
    (
        "featureAngle", controls.featureAngle, 1, 90,
        "Edges with a larger angle between normals are kept [deg]"
    );
    entries.readBounded
    (
        "growthRate", controls.growthRate, 1.01, 2,
        "Length of an edge over the length of the edge before it, at most"
    );
    declareParts(entries, controls);
    entries.readBounded
    (
        "edgePerGap", controls.edgePerGap, 0.1, 100,
        "Length of edges beside a gap over the width of the gap, at most"
    );
}


// * * * * * * * * * * * * * * * *  Far Field  * * * * * * * * * * * * * * * //

const wordList farFieldTypes({"none", "tet", "hexCore", "mesh"});

const wordList farBoundaryTypes({"box", "sphere", "surface"});


//- Refuses the keys of the other kinds of boundary
static void checkKind(const dictionary& dict, const wordList& own)
{
    for (const entry& e : dict)
    {
        const word& key = e.keyword();
        if (key != "type" && key != "patches" && !own.found(key))
        {
            entryError(dict, key)
                << "The entry " << key << " is not one of a far"
                << " boundary of type " << dict.get<word>("type") << nl
                << "Its entries: patches, " << listed(own).c_str()
                << exit(FatalIOError);
        }
    }
}


static void checkBox(const dictionary& dict, const boundBox& box)
{
    // Written so that values that are no numbers fail
    if (!(cmptMin(box.span()) > 0 && box.mag() < GREAT))
    {
        entryError(dict, "max")
            << "Value of max is " << box.max() << "; it must be more than min "
            << box.min() << " in all directions" << exit(FatalIOError);
    }
}


cyclicControls readCyclic
(
    controlEntries& entries,
    const word& type,
    const bool mayRotate
)
{
    cyclicControls cyclic;
    entries.read
    (
        "partner", cyclic.partner, "The other patch of a cyclic pair", "word"
    );
    const bool rotates = mayRotate && entries.readDict
    (
        "rotation", "Rotation to the partner", [&](controlEntries& rotation)
        {
            rotation.read("axis", cyclic.axis, "Axis", "vector");
            rotation.read
            (
                "origin", cyclic.origin, "Point of the axis", "point"
            );
            rotation.readBounded
            (
                "angle", cyclic.angle, -180, 180, "Angle to the partner [deg]"
            );
            for (const word key : {"axis", "origin", "angle"})
            {
                rotation.require(key);
            }
        }
    );

    if ((cyclic.partner.size() || rotates) && type != "cyclic")
    {
        entryError(*entries.dict(), "type")
            << "Patches with a partner or a rotation are of type cyclic, not "
            << type << exit(FatalIOError);
    }
    if (rotates && (!(mag(cyclic.axis) > 0) || cyclic.partner.empty()))
    {
        entryError(*entries.dict(), "rotation")
            << "The rotation must have an axis that is not zero, and is of the"
            << " patch that has the partner" << exit(FatalIOError);
    }

    return cyclic;
}


static void declareFarPatch
(
    controlEntries& entries,
    const keyType& key,
    farPatch& patch
)
{
    if (entries.dict() && key.isPattern())
    {
        entryError(*entries.dict(), key)
            << "The patch " << key << " of the far boundary must have a name"
            << exit(FatalIOError);
    }
    patch.name = key;
    patch.sides = wordRes(1, wordRe(key));
    entries.readChoice("type", patch.type, planeTypes, "Type of the patch");
    patch.cyclic = readCyclic(entries, patch.type, false);
    entries.read
    (
        "sides", patch.sides, "Sides of the boundary in the patch",
        "words or regular expressions", "the side with the patch's name"
    );
}


//- Declares where the boundary of each type is
static void declarePlace(controlEntries& entries, farBoundaryControls& boundary)
{
    entries.read("min", boundary.box.min(), "Lower corner of a box", "point");
    entries.read("max", boundary.box.max(), "Upper corner of a box", "point");
    entries.read("origin", boundary.origin, "Centre of a sphere", "point");
    entries.readBounded
    (
        "radius", boundary.radius, 1e-9, 1e9, "Radius of a sphere [m]"
    );
    entries.read("file", boundary.file, "File of a surface", "file");
    entries.readBounded
    (
        "scale", boundary.scale, 1e-9, 1e9,
        "Factor on the coordinates of a surface"
    );
}


static void declare(controlEntries& entries, farBoundaryControls& boundary)
{
    static const List<wordList> needed
    ({
        wordList({"min", "max"}), wordList({"origin", "radius"}),
        wordList({"file"})
    });

    word type;
    entries.readChoice
    (
        "type", type, farBoundaryTypes, "Form of the far boundary"
    );
    entries.require("type");
    declarePlace(entries, boundary);
    entries.readDicts
    (
        "patches", boundary.patches, "Patches in place of sides",
        declareFarPatch
    );

    const dictionary* dict = entries.dict();
    if (!dict)
    {
        return;
    }
    const label typei = farBoundaryTypes.find(type);
    boundary.type = farBoundaryType(typei);
    wordList own(needed[typei]);
    for (const word& key : own)
    {
        entries.require(key);
    }
    if (boundary.type == farBoundaryType::surface)
    {
        own.append("scale");
    }
    checkKind(*dict, own);

    const bool isBox = boundary.type == farBoundaryType::box;
    if (isBox)
    {
        checkBox(*dict, boundary.box);
    }
    if (!isBox && anyOf(boundary.patches, [](const farPatch& patch)
        { return patch.type == "cyclic"; }))
    {
        entryError(*dict, "type")
            << "Patches of type cyclic are possible with farField.boundary.type"
            << " box alone"
            << exit(FatalIOError);
    }
}


//- Refuses the entries of other types of far field
static void refuseOtherTypes(const dictionary& dict, const farFieldType type)
{
    const auto refuse = [&](const word& key, const char* types)
    {
        if (dict.found(key, keyType::LITERAL))
        {
            entryError(dict, key)
                << "The entry " << key << " is for a far field of type "
                << types << ", but farField.type is "
                << farFieldTypes[int(type)] << exit(FatalIOError);
        }
    };

    if (type == farFieldType::mesh)
    {
        refuse("boundary", "tet or hexCore");
    }
    if (type == farFieldType::tet)
    {
        refuse("gap", "hexCore or mesh");
    }
    if (type == farFieldType::tet || type == farFieldType::hexCore)
    {
        refuse("region", "mesh");
    }
}


//- Declares the sizes of the cells of the far field
static void declareSizes(controlEntries& entries, farFieldControls& controls)
{
    entries.readBounded
    (
        "growthRate", controls.growthRate, 1.01, 2,
        "Size of a cell over the size of its neighbour nearer to the wall"
    );
    entries.readBounded
    (
        "maxCellSize", controls.maxCellSize, 1e-9, 1e9,
        "Length of edges, at most [m]"
    );
    entries.readBounded
    (
        "maxCells", controls.maxCells, 1, 2e8, "Number of cells, at most"
    );
    entries.readDicts
    (
        "regions", controls.regions, "Sizes in parts of space",
        [](controlEntries& part, const keyType& key, sizeRegion& region)
        {
            declareRegion(part, key, region);
            part.readBounded
            (
                "cellSize", region.cellSize, 1e-9, 1e9,
                "Length of edges there, at most [m]"
            );
            part.require("cellSize");
        }
    );
}


//- Refuses a boundary where the fluid is inside of the wall, and a far field
//  outside of the wall without one
static void checkBoundary
(
    const dictionary& dict,
    const farFieldControls& controls,
    const wallSurfaceControls& surface
)
{
    // An open wall inside of which the fluid is may have one. The point inside
    // tells later where the fluid is.
    const bool hasBoundary = dict.found("boundary", keyType::LITERAL);
    const bool isKnown = surface.isFluidGiven || !surface.hasInside;
    if
    (
        isKnown && controls.isWanted() && controls.type != farFieldType::mesh
     && hasBoundary != surface.fluidOutside && surface.sidePlanes.empty()
     && controls.boundary.type != farBoundaryType::box
    )
    {
        entryError(dict, hasBoundary ? "boundary" : "type")
            << (surface.fluidOutside
              ? "The far field has no boundary: give it one, a box, a sphere or"
                " a surface"
              : "The fluid is inside of the wall: there is no far boundary."
                " Remove the entry boundary, or write surface { fluid outside;"
                " }")
            << exit(FatalIOError);
    }
}


void declare
(
    controlEntries& entries,
    farFieldControls& controls,
    const wallSurfaceControls& surface
)
{
    entries.readChoice
    (
        "type", controls.type, farFieldTypes, "Cells around the layers"
    );
    entries.readDict
    (
        "boundary", "The far boundary", [&](controlEntries& boundary)
        {
            declare(boundary, controls.boundary);
        }
    );
    declareSizes(entries, controls);
    entries.readBounded
    (
        "gap", controls.gap, 0.1, 10,
        "Distance of a hexCore or a mesh from the layers in widths of its cells"
    );
    entries.readFlag
    (
        "polyhedra", controls.polyhedra,
        "Tetrahedra merge where plain schemes would not converge"
    );
    entries.read
    (
        "region", controls.region, "Region of an existing mesh", "word",
        "the mesh of the case"
    );

    if (entries.dict())
    {
        refuseOtherTypes(*entries.dict(), controls.type);
        checkBoundary(*entries.dict(), controls, surface);
    }
}

} // End namespace Foam

// ************************************************************************* //
