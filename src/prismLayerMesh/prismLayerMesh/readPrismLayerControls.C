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

static fileNameList readFiles(const dictionary& dict)
{
    const bool isOne = dict.found("file", keyType::LITERAL);
    const word key(isOne ? "file" : "files");
    fileNameList files(1);

    if (isOne && dict.found("files", keyType::LITERAL))
    {
        entryError(dict, "files")
            << "Give file or files, not both" << exit(FatalIOError);
    }

    if (isOne)
    {
        dict.readEntry(key, files[0]);
    }
    else if (dict.found(key, keyType::LITERAL))
    {
        dict.readEntry(key, files);
    }
    else
    {
        missingEntry(dict, "file");
    }

    if (files.empty() || files.found(fileName()))
    {
        entryError(dict, key)
            << "Value of " << key << " is empty; it must be the name of a"
            << " surface file" << exit(FatalIOError);
    }

    return files;
}


static sidePatch readSidePlane(const keyType& key, const dictionary& dict)
{
    checkKeys(dict, {"point", "normal", "type", "partner", "rotation"});

    sidePatch plane;
    plane.name = key;
    dict.readEntry("point", plane.origin);
    dict.readEntry("normal", plane.normal);
    readChoice(dict, "type", planeTypes, plane.type);
    plane.cyclic = readCyclic(plane.type, dict);

    if (key.isPattern() || !(mag(plane.normal) > 0))
    {
        entryError(dict, key)
            << "The side plane " << key << (key.isPattern()
              ? " must have a name" : " must have a normal that is not zero")
            << exit(FatalIOError);
    }
    plane.normal.normalise();

    return plane;
}


static surfacePatchName readPatchName
(
    const keyType& key,
    const dictionary& dict
)
{
    checkKeys(dict, {"file", "solid"});

    surfacePatchName patch;
    patch.name = key;
    dict.readIfPresent("file", patch.file);
    dict.readIfPresent("solid", patch.solid);

    if (key.isPattern() || dict.empty())
    {
        entryError(dict, key)
            << "The patch " << key << (key.isPattern()
              ? " must have a name" : " must have a file, a solid, or both")
            << exit(FatalIOError);
    }

    return patch;
}


static surfaceCadControls readCad(const dictionary& dict)
{
    checkKeys(dict, {"maxEdge", "nPerCircle", "maxSeconds"});

    surfaceCadControls controls;
    readBounded(dict, "maxEdge", SMALL, GREAT, controls.maxEdge);
    readBounded(dict, "nPerCircle", 4, 100, controls.nPerCircle);
    readBounded(dict, "maxSeconds", 1, 1000000, controls.maxSeconds);

    return controls;
}


static surfaceRepairControls readRepair(const dictionary& dict)
{
    surfaceRepairControls controls;
    readChoice(dict, "repair", {"none", "stitch", "wrap"}, controls.repair);

    const dictionary& stitch = optionalDict(dict, "stitchCoeffs");
    checkKeys(stitch, {"gap", "hole"});
    readBounded(stitch, "gap", SMALL, GREAT, controls.gap);
    readBounded(stitch, "hole", SMALL, GREAT, controls.hole);

    const dictionary& wrap = optionalDict(dict, "wrapCoeffs");
    checkKeys(wrap, {"size", "offset", "seeds"});
    readBounded(wrap, "size", SMALL, GREAT, controls.size);
    readBounded(wrap, "offset", SMALL, GREAT, controls.offset);
    wrap.readIfPresent("seeds", controls.seeds);

    return controls;
}


static planarControls readPlanar(const dictionary& dict)
{
    planarControls controls;
    if (!dict.found("twoDimensional"))
    {
        return controls;
    }

    const dictionary& planar = dict.subDict("twoDimensional");
    checkKeys
    (
        planar,
        {
            "normal", "thickness", "sectionAt", "maxEdge", "maxTurn",
            "wedgeAngle"
        }
    );
    planar.readIfPresent("normal", controls.normal);
    if (mag(cmptMax(cmptMag(controls.normal)) - mag(controls.normal)) > 0)
    {
        entryError(planar, "normal")
            << "The normal " << controls.normal << " of twoDimensional is not"
            << " along an axis" << exit(FatalIOError);
    }
    controls.normal.normalise();
    controls.thickness = 1;
    readBounded(planar, "thickness", SMALL, GREAT, controls.thickness);
    readBounded(planar, "sectionAt", -1e9, 1e9, controls.sectionAt);
    readBounded(planar, "maxEdge", SMALL, GREAT, controls.maxEdge);
    scalar maxTurn = radToDeg(controls.maxTurn);
    readBounded(planar, "maxTurn", 0.1, 30, maxTurn);
    controls.maxTurn = degToRad(maxTurn);
    scalar wedgeAngle = 0;
    readBounded(planar, "wedgeAngle", 0.01, 20, wedgeAngle);
    controls.wedgeAngle = degToRad(wedgeAngle);

    return controls;
}


static wallSurfaceControls readSurface(const dictionary& dict)
{
    checkKeys
    (
        dict,
        {
            "file", "files", "patches", "fluid", "scale", "mergeTolerance",
            "sidePlanes", "cad", "repair", "stitchCoeffs", "wrapCoeffs",
            "remesh", "baffles", "inside", "acceptLoss"
        }
    );

    wallSurfaceControls controls;
    controls.files = readFiles(dict);
    controls.patches =
        readEntries<surfacePatchName>(dict, "patches", readPatchName);
    controls.sidePlanes =
        readEntries<sidePatch>(dict, "sidePlanes", readSidePlane);

    word fluid(controls.fluidOutside ? "outside" : "inside");
    readChoice(dict, "fluid", {"outside", "inside"}, fluid);
    controls.fluidOutside = (fluid == "outside");
    controls.isFluidGiven = dict.found("fluid", keyType::LITERAL);
    controls.hasInside = dict.readIfPresent("inside", controls.inside);
    dict.readIfPresent("acceptLoss", controls.acceptedLosses);

    readBounded(dict, "scale", 1e-9, 1e9, controls.scale);
    readBounded(dict, "mergeTolerance", 0, 1e-3, controls.mergeTolerance);
    controls.cad = readCad(optionalDict(dict, "cad"));
    controls.repair = readRepair(dict);
    controls.remesh = readRemeshControls(dict);
    if (dict.found("baffles", keyType::LITERAL))
    {
        entryError(dict, "baffles")
            << "Sheets of no thickness are possible with regions. One region"
            << " is enough: regions { fluid { inside (x y z); } }"
            << exit(FatalIOError);
    }

    return controls;
}


static envelopeControls readEnvelope(const dictionary& dict)
{
    checkKeys(dict, {"scale"});

    envelopeControls controls;
    readBounded(dict, "scale", 1, 10, controls.scale);

    return controls;
}


static backgroundMeshControls readBackgroundMesh
(
    const dictionary& dict,
    const bool onLevelSets
)
{
    checkKeys(dict, {"radiusEdgeRatio", "minSheets"});

    backgroundMeshControls controls;
    if (onLevelSets)
    {
        controls.minSheets = backgroundMeshControls::levelSetSheets;
    }
    readBounded(dict, "minSheets", 0, 10, controls.minSheets);
    readBounded(dict, "radiusEdgeRatio", 1, 10, controls.radiusEdgeRatio);

    return controls;
}


static qualityControls readQuality(const dictionary& dict)
{
    checkKeys
    (
        dict,
        {
            "maxNonOrtho", "maxInternalSkewness", "minFaceWeight",
            "minVolRatio", "minTetQuality", "priority"
        }
    );

    qualityControls controls;
    readBounded(dict, "maxNonOrtho", 30, 90, controls.maxNonOrtho);
    readBounded
    (
        dict, "maxInternalSkewness", 1, 100, controls.maxInternalSkewness
    );
    readBounded(dict, "minFaceWeight", 0, 0.5, controls.minFaceWeight);
    readBounded(dict, "minVolRatio", 0, 1, controls.minVolRatio);
    readBounded(dict, "minTetQuality", -1e30, 1, controls.minTetQuality);

    readChoice(dict, "priority", {"quality", "thickness"}, controls.priority);

    return controls;
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


//- Reads the form of the cells. Refuses polygons beside what they cannot be
//  made with.
static void readCells(const dictionary& dict, prismLayerControls& controls)
{
    word cells("triangles");
    readChoice(dict, "cells", {"triangles", "polygons"}, cells);
    controls.polygons = (cells == "polygons");
    if (!controls.polygons)
    {
        return;
    }
    const auto refuse = [&](const bool isThere, const char* what)
    {
        if (isThere)
        {
            entryError(dict, "cells")
                << "cells polygons is not possible with " << what
                << ": use cells triangles" << exit(FatalIOError);
        }
    };
    const farFieldControls& far = controls.farField;
    refuse(controls.surface.planar.isWanted(), "twoDimensional");
    refuse
    (
        far.type == farFieldType::mesh,
        "farField.type mesh, whose cells stay as they are"
    );
    controls.farField.forPolygons = true;
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismLayerControls readPrismLayerControls(const dictionary& dict)
{
    checkKeys
    (
        dict,
        {
            "surface",
            "layers",
            "envelope",
            "backgroundMesh",
            "field",
            "quality",
            "farField",
            "twoDimensional",
            "cells"
        }
    );

    prismLayerControls controls;
    controls.surface = readSurface(mandatoryDict(dict, "surface"));
    controls.surface.planar = readPlanar(dict);
    controls.layers = readLayerControls(mandatoryDict(dict, "layers"));
    if (controls.surface.planar.isWanted())
    {
        setPlanar(dict.subDict("layers"), controls);
    }
    controls.envelope = readEnvelope(optionalDict(dict, "envelope"));
    controls.backgroundMesh =
        readBackgroundMesh
        (
            optionalDict(dict, "backgroundMesh"), controls.layers.onLevelSets
        );
    controls.field = readFieldControls
    (
        optionalDict(dict, "field"), controls.layers.onLevelSets
    );
    controls.quality = readQuality(optionalDict(dict, "quality"));
    controls.farField = readFarFieldControls
    (
        optionalDict(dict, "farField"), controls.surface
    );
    if (controls.farField.isWanted())
    {
        refuseEmptySides(dict, controls);
    }
    readCells(dict, controls);

    const List<sidePatch>& planes = controls.surface.sidePlanes;
    controls.surface.planar.sides = planes;
    controls.surface.planar.sides.append
    (
        freeSides(controls.farField.boundary, planes)
    );

    return controls;
}

} // End namespace Foam

// ************************************************************************* //
