/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readPrismLayerControls.H"
#include "boxSides.H"
#include "controlEntries.H"
#include "diffusionTensor.H"
#include "planarWall.H"
#include "ranges.H"
#include "readControls.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void declareFiles(controlEntries& entries, fileNameList& files)
{
    const string kind("a file, or a path");
    fileName file;
    const bool isOne =
        entries.read("file", file, "The surface, in constant/triSurface", kind);
    const bool areSeveral = entries.read
    (
        "files", files, "Several files in place of one", "files"
    );
    const dictionary* dict = entries.dict();
    if (!dict)
    {
        return;
    }

    if (isOne && areSeveral)
    {
        entryError(*dict, "files")
            << "Give file or files, not both" << exit(FatalIOError);
    }
    if (isOne)
    {
        files = fileNameList(1, file);
    }
    else if (!areSeveral)
    {
        missingEntry(*dict, "file");
    }
    if (files.empty() || files.found(fileName()))
    {
        const word key(isOne ? "file" : "files");
        entryError(*dict, key)
            << "Value of " << key << " is empty; it must be the name of a"
            << " surface file" << exit(FatalIOError);
    }
}


static void declareSidePlane
(
    controlEntries& entries,
    const keyType& key,
    sidePatch& plane
)
{
    plane.name = key;
    entries.read("point", plane.origin, "A point of the plane", "point");
    entries.read
    (
        "normal", plane.normal, "Normal of the plane, out of the fluid",
        "vector"
    );
    entries.readChoice("type", plane.type, planeTypes, "Type of the patch");
    plane.cyclic = readCyclic(entries, plane.type, true);
    entries.require("point");
    entries.require("normal");

    if
    (
        entries.dict() && (key.isPattern() || !(mag(plane.normal) > 0))
    )
    {
        entryError(*entries.dict(), key)
            << "The side plane " << key << (key.isPattern()
              ? " must have a name" : " must have a normal that is not zero")
            << exit(FatalIOError);
    }
    plane.normal.normalise();
}


static void declarePatchName
(
    controlEntries& entries,
    const keyType& key,
    surfacePatchName& patch
)
{
    const string kind("word or regular expression");
    patch.name = key;
    entries.read("file", patch.file, "Files of the patch", kind, "all files");
    entries.read
    (
        "solid", patch.solid, "Solids of the patch", kind, "all solids"
    );

    const dictionary* dict = entries.dict();
    if (dict && (key.isPattern() || dict->empty()))
    {
        entryError(*dict, key)
            << "The patch " << key << (key.isPattern()
              ? " must have a name" : " must have a file, a solid, or both")
            << exit(FatalIOError);
    }
}


static void declare(controlEntries& entries, surfaceCadControls& controls)
{
    entries.readBounded
    (
        "maxEdge", controls.maxEdge, SMALL, GREAT,
        "Length of edges on CAD faces, at most [m]", "0.03 of the diagonal"
    );
    entries.readBounded
    (
        "nPerCircle", controls.nPerCircle, 4, 100,
        "Edges on a full circle of a curved CAD face"
    );
    entries.readBounded
    (
        "maxSeconds", controls.maxSeconds, 1, 1e6,
        "Time that gmsh may take for a file [s]"
    );
}


static void declare(controlEntries& entries, surfaceRepairControls& controls)
{
    entries.readChoice
    (
        "repair", controls.repair, {"none", "stitch", "wrap"},
        "How a surface with defects becomes a wall"
    );
    entries.readDict
    (
        "stitchCoeffs", "Of repair stitch", [&](controlEntries& stitch)
        {
            stitch.readBounded
            (
                "gap", controls.gap, SMALL, GREAT,
                "Gaps narrower than this are closed [m]", "1e-4 of the diagonal"
            );
            stitch.readBounded
            (
                "hole", controls.hole, SMALL, GREAT,
                "Holes narrower than this are filled [m]",
                "0.05 of the diagonal"
            );
        }
    );
    entries.readDict
    (
        "wrapCoeffs", "Of repair wrap", [&](controlEntries& wrap)
        {
            wrap.readBounded
            (
                "size", controls.size, SMALL, GREAT,
                "Diameter of a ball that gets into openings [m]",
                "0.01 of the diagonal"
            );
            wrap.readBounded
            (
                "offset", controls.offset, SMALL, GREAT,
                "Distance of the wrap before it is brought back [m]",
                "0.1 of size"
            );
            wrap.read
            (
                "seeds", controls.seeds, "Points of the fluid", "points"
            );
        }
    );
}


static void declare(controlEntries& entries, planarControls& controls)
{
    controls.thickness = 1;
    entries.read
    (
        "normal", controls.normal, "Normal of the plane", "an axis", "(0 0 1)"
    );
    entries.readBounded
    (
        "thickness", controls.thickness, SMALL, GREAT,
        "Distance of front and back [m]"
    );
    entries.readBounded
    (
        "sectionAt", controls.sectionAt, -1e9, 1e9,
        "Where the plane cuts a surface [m]", "0"
    );
    scalar maxEdge = 0;
    entries.readBounded
    (
        "maxEdge", maxEdge, SMALL, GREAT,
        "Length of edges, at most [m]", "none: the points of the file"
    );
    controls.maxEdge = maxEdge > 0 ? maxEdge : controls.maxEdge;
    scalar maxTurn = radToDeg(controls.maxTurn);
    entries.readBounded
    (
        "maxTurn", maxTurn, 0.1, 30, "Angle between two edges, at most [deg]",
        "2.86"
    );
    controls.maxTurn = degToRad(maxTurn);
    scalar wedgeAngle = 0;
    entries.readBounded
    (
        "wedgeAngle", wedgeAngle, 0.01, 20, "Angle of a wedge [deg]",
        "none: the mesh is plane"
    );
    controls.wedgeAngle = degToRad(wedgeAngle);

    if (mag(cmptMax(cmptMag(controls.normal)) - mag(controls.normal)) > 0)
    {
        entryError(*entries.dict(), "normal")
            << "The normal " << controls.normal << " of twoDimensional is not"
            << " along an axis" << exit(FatalIOError);
    }
    controls.normal.normalise();
}


//- Declares where the fluid is
static void declareFluid(controlEntries& entries, wallSurfaceControls& controls)
{
    controls.isFluidGiven = entries.readChoice
    (
        "fluid", controls.fluidOutside, {"inside", "outside"},
        "Side of the surface on which the fluid is"
    );
    controls.hasInside = entries.read
    (
        "inside", controls.inside, "A point in the fluid", "point"
    );
}


static void declare(controlEntries& entries, wallSurfaceControls& controls)
{
    const string patches("words or regular expressions");
    declareFiles(entries, controls.files);
    entries.readDicts
    (
        "patches", controls.patches, "Names of patches", declarePatchName
    );
    entries.readDicts
    (
        "sidePlanes", controls.sidePlanes, "Planes on which the wall ends",
        declareSidePlane
    );
    declareFluid(entries, controls);
    entries.read
    (
        "acceptLoss", controls.acceptedLosses,
        "Patches of which the wall may miss parts", patches, "none"
    );
    entries.readBounded
    (
        "scale", controls.scale, 1e-9, 1e9, "Factor on the coordinates"
    );
    entries.readBounded
    (
        "mergeTolerance", controls.mergeTolerance, 0, 1e-3,
        "Points nearer to each other than this share of the diagonal are one",
        "0"
    );
    entries.readDict("cad", "Triangles of CAD files", [&](controlEntries& cad)
    {
        declare(cad, controls.cad);
    });
    declare(entries, controls.repair);
    controls.remesh.active = entries.readDict
    (
        "remesh", "New triangles", [&](controlEntries& remesh)
        {
            declare(remesh, controls.remesh);
        }
    );
    const bool hasBaffles = entries.has
    (
        "baffles", "Patches of sheets of no thickness, with regions", patches
    );
    if (hasBaffles)
    {
        entryError(*entries.dict(), "baffles")
            << "Sheets of no thickness are possible with regions. One region"
            << " is enough: regions { fluid { inside (x y z); } }"
            << exit(FatalIOError);
    }
}


static void declare(controlEntries& entries, backgroundMeshControls& controls)
{
    entries.readBounded
    (
        "radiusEdgeRatio", controls.radiusEdgeRatio, 1, 10,
        "d of the paper: distance of points of a sheet over its height"
    );
    entries.readBounded
    (
        "minSheets", controls.minSheets, 0, 10,
        "Sheets of points below the envelope, at least", "0; 2 with levelSets"
    );
}


static void declare(controlEntries& entries, qualityControls& controls)
{
    entries.readBounded
    (
        "maxNonOrtho", controls.maxNonOrtho, 30, 90,
        "Non-orthogonality of a face, at most [deg]"
    );
    entries.readBounded
    (
        "maxInternalSkewness", controls.maxInternalSkewness, 1, 100,
        "Skewness of a face, at most"
    );
    entries.readBounded
    (
        "minFaceWeight", controls.minFaceWeight, 0, 0.5,
        "Distance of the nearer centre over that of both, at least"
    );
    entries.readBounded
    (
        "minVolRatio", controls.minVolRatio, 0, 1,
        "Volume of the smaller cell over that of the larger, at least"
    );
    entries.readBounded
    (
        "minTetQuality", controls.minTetQuality, -1e30, 1,
        "Quality of the tetrahedra of a face, at least"
    );
    entries.readChoice
    (
        "priority", controls.priority, {"quality", "thickness"},
        "What is kept if not both can be"
    );
}


//- Refuses side patches of type empty beside a far field that has several cells
//  between them: all but two planes with tetrahedra
static void refuseEmptySides
(
    const dictionary& dict,
    const prismLayerControls& controls
)
{
    const auto refuse = [&](const string& name, const word& type)
    {
        if (type == "empty")
        {
            entryError(dict, "farField")
                << "The side patch " << name.c_str() << " is of type empty, but"
                << " the far field has several cells between two sides" << nl
                << "Use the type symmetry. One cell between two planes is"
                << " possible with farField.type tet and both planes in"
                << " surface.sidePlanes"
                << exit(FatalIOError);
        }
    };

    const label nEmpty = countOf
    (
        controls.surface.sidePlanes,
        [](const sidePatch& plane) { return plane.type == "empty"; }
    );
    const bool isPlanar =
        controls.farField.type == farFieldType::tet && nEmpty == 2;
    for (const sidePatch& plane : controls.surface.sidePlanes)
    {
        if (!isPlanar)
        {
            refuse(plane.name, plane.type);
        }
    }
    for (const patchLayers& entry : controls.layers.patches)
    {
        refuse(entry.patches, entry.type);
    }
    for (const farPatch& patch : controls.farField.boundary.patches)
    {
        refuse(patch.name, patch.type);
    }
}


//- Refuses polygons beside what they cannot be made with
static void checkCells
(
    const dictionary& dict,
    const prismLayerControls& controls
)
{
    const auto refuse = [&](const bool isThere, const char* what)
    {
        if (controls.polygons && isThere)
        {
            entryError(dict, "cells")
                << "cells polygons is not possible with " << what
                << ": use cells triangles" << exit(FatalIOError);
        }
    };
    refuse(controls.surface.planar.isWanted(), "twoDimensional");
    refuse
    (
        controls.farField.type == farFieldType::mesh,
        "farField.type mesh, whose cells stay as they are"
    );
}


//- The defaults of two dimensions that differ, and the sides
static void setPlanar(const dictionary& layers, prismLayerControls& controls)
{
    controls.surface.sidePlanes.append(planesOf(controls.surface.planar));
    controls.layers.alongField =
        controls.layers.alongField && layers.found("marchingDirections");
    if (!layers.found("multipleNormalsAngle"))
    {
        // A fan at each corner that turns by more than 30 degrees
        controls.layers.multipleNormalsAngle = 75;
    }
}


//- Declares the dictionaries of surface and layers
static void declareWall(controlEntries& entries, prismLayerControls& controls)
{
    entries.readDict("surface", "The wall", [&](controlEntries& surface)
    {
        declare(surface, controls.surface);
    });
    entries.readChoice
    (
        "cells", controls.polygons, {"triangles", "polygons"},
        "Form of the faces of layers and of the cells of the far field"
    );
    entries.readDict
    (
        "twoDimensional", "A mesh of one cell between two planes",
        [&](controlEntries& planar)
        {
            declare(planar, controls.surface.planar);
        }
    );
    entries.readDict("layers", "The layers", [&](controlEntries& layers)
    {
        declare(layers, controls.layers);
    });
    if (entries.dict())
    {
        mandatoryDict(*entries.dict(), "surface");
        const dictionary& layers = mandatoryDict(*entries.dict(), "layers");
        if (controls.surface.planar.isWanted())
        {
            setPlanar(layers, controls);
        }
    }
}


//- Declares the dictionaries of the field and its mesh
static void declareField(controlEntries& entries, prismLayerControls& controls)
{
    entries.readDict("envelope", "The envelope", [&](controlEntries& envelope)
    {
        envelope.readBounded
        (
            "scale", controls.envelope.scale, 1, 10,
            "t of the paper: distance of the envelope over the thickness"
        );
    });
    if (controls.layers.onLevelSets)
    {
        controls.backgroundMesh.minSheets =
            backgroundMeshControls::levelSetSheets;
        controls.field.tensor = fieldControls::levelSetTensor;
    }
    entries.readDict
    (
        "backgroundMesh", "The mesh of the field", [&](controlEntries& mesh)
        {
            declare(mesh, controls.backgroundMesh);
        }
    );
    entries.readDict("field", "The harmonic field", [&](controlEntries& field)
    {
        declare(field, controls.field);
    });
}


//- Declares all entries, in the order in which one needs the other
static void declare(controlEntries& entries, prismLayerControls& controls)
{
    declareWall(entries, controls);
    declareField(entries, controls);
    entries.readDict
    (
        "quality", "Bounds on faces between cells", [&](controlEntries& quality)
        {
            declare(quality, controls.quality);
        }
    );
    entries.readDict
    (
        "farField", "The rest of the mesh", [&](controlEntries& farField)
        {
            declare(farField, controls.farField, controls.surface);
        }
    );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismLayerControls readPrismLayerControls(const dictionary& dict)
{
    prismLayerControls controls;
    controlEntries::read(dict, [&](controlEntries& entries)
    {
        declare(entries, controls);
    });
    if (controls.farField.isWanted())
    {
        refuseEmptySides(dict, controls);
    }
    checkCells(dict, controls);
    controls.farField.forPolygons = controls.polygons;

    const List<sidePatch>& planes = controls.surface.sidePlanes;
    controls.surface.planar.sides = planes;
    controls.surface.planar.sides.append
    (
        freeSides(controls.farField.boundary, planes)
    );

    return controls;
}


List<entryText> prismLayerEntries()
{
    prismLayerControls controls;

    return controlEntries::list([&](controlEntries& entries)
    {
        declare(entries, controls);
    });
}

} // End namespace Foam

// ************************************************************************* //
