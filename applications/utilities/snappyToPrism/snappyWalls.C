/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "snappyWalls.H"
#include "fluidSide.H"
#include "controlEntries.H"
#include "OSspecific.H"
#include "ranges.H"
#include "readWallSurface.H"
#include "surfaceFile.H"
#include "surfacePart.H"
#include "surfaceMeasures.H"
#include "triPointRef.H"

#include <cstring>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A pattern that matches the text. Without a plain metacharacter a string is
//  no pattern, hence the brackets.
static string patternOf(const string& text)
{
    string result;
    for (const char c : text)
    {
        result += strchr("\\+*?^$|(){}[]", c) ? "\\" : "";
        result += c;
    }

    return result == text ? text : string('(' + result + ')');
}


//- Sets what refinementSurfaces, or one of its regions, says of a patch
static void readPatch(const dictionary& dict, snappyPatch& patch)
{
    labelPair levels(patch.level, patch.finest);
    dict.readIfPresent("level", levels);
    patch.level = levels.first();
    patch.finest = levels.second();
    const dictionary& info = dict.subOrEmptyDict("patchInfo");
    info.readIfPresent("type", patch.type);
    info.readIfPresent("inGroups", patch.groups);
}


//- Whether refinementSurfaces asks for baffles on a faceZone
static bool isBaffle(const dictionary& refinement)
{
    const word type(refinement.getOrDefault<word>("faceType", "internal"));

    return refinement.found("faceZone") && type != "internal";
}


//- Whether a surface is a zone in the fluid alone, and no wall
static bool isZone
(
    const word& name,
    const dictionary& refinement,
    remarkList& remarks
)
{
    const bool hasCells = refinement.found("cellZone");
    if (!hasCells && (isBaffle(refinement) || !refinement.found("faceZone")))
    {
        return false;
    }
    remarks.append
    (
        isBaffle(refinement)
      ? "The baffle " + name + " has the cellZone "
      + refinement.get<word>("cellZone") + " and is left out. Name it in"
        " surface.baffles, and give a point of each side in regions"
      : "The zone " + name + " is in the fluid, no wall"
    );

    return true;
}


//- Appends a file, and the patches that snappyHexMesh makes of its regions
static void appendFile
(
    const fileName& path,
    const word& name,
    const dictionary& geometry,
    const dictionary& refinement,
    const bool isRegionNamed,
    snappyWalls& walls
)
{
    bool separate;
    wallSurface part(readSurfaceFile(path, separate));
    mergePatches(part);
    part.points *= walls.scale;
    const List<patchMeasures> measures(measuresOfPatches(part));
    const dictionary& named = geometry.subOrEmptyDict("regions");
    const dictionary& refined = refinement.subOrEmptyDict("regions");
    forAll(measures, i)
    {
        const word region(part.patchNames[i]);
        const bool isAlone = measures.size() == 1 && !isRegionNamed;
        snappyPatch patch;
        patch.name = isAlone ? name : word(name + '_' + region);
        patch.area = measures[i].area;
        patch.isBaffle = isBaffle(refinement);
        readPatch(refinement, patch);
        if (const dictionary* dict = refined.findDict(region, keyType::REGEX))
        {
            readPatch(*dict, patch);
        }
        named.subOrEmptyDict(region).readIfPresent("name", patch.name);
        patch.name = word::validate(patch.name, true);

        dictionary entry;
        entry.add("file", patternOf(path.name()));
        entry.add("solid", patternOf(region));
        walls.names.set(patch.name, entry);
        walls.patches.append(patch);
        part.patchNames[i] = patch.name;
    }
    walls.files.append(path.name());
    appendSurface
    (
        part, labelList(), isBaffle(refinement) ? walls.sheets : walls.surface
    );
}


//- Errors: FatalError if there is no wall, or if a wall has no file
static void requireFiles
(
    const snappyWalls& walls,
    const UList<string>& missing,
    const dictionary& layers
)
{
    if (missing.size())
    {
        FatalErrorInFunction
            << "Walls of refinementSurfaces without a surface file in"
            << " constant/triSurface: " << listed(missing).c_str() << nl
            << "Write each as an STL or OBJ file into this folder, and name it"
            << " in geometry: <name> { type triSurfaceMesh; file \"...\"; }"
            << exit(FatalError);
    }
    if (walls.files.empty())
    {
        FatalErrorInFunction
            << "refinementSurfaces has no wall, and layers are made on surface"
            << " files alone, not on faceZones or sides of the box. The layers"
            << " of snappyHexMeshDict are on: " << flatOutput(layers.toc())
            << exit(FatalError);
    }
}


//- 4 pi times the number of times that a triangle goes around a point
static scalar solidAngle(const triPointRef& triangle, const point& x)
{
    const vector a(triangle.a() - x), b(triangle.b() - x), c(triangle.c() - x);
    const scalar p = mag(a), q = mag(b), r = mag(c);

    return
        2*std::atan2(a & (b ^ c), p*q*r + (a & b)*r + (b & c)*p + (c & a)*q);
}


//- Whether walls span the domain in two directions, as a ground does
static bool isGround(const boundBox& walls, const blockBox& box)
{
    const scalar tolerance = 1e-4*box.bounds.mag();
    label nSpanned = 0;
    for (direction d = 0; d < 3 && box.isFound; ++d)
    {
        nSpanned +=
            walls.min()[d] < box.bounds.min()[d] + tolerance
         && walls.max()[d] > box.bounds.max()[d] - tolerance;
    }

    return nSpanned > 1;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

label snappyWalls::level() const
{
    Map<scalar> areas;
    for (const snappyPatch& patch : patches)
    {
        areas(patch.level) += patch.area;
    }
    label largest = patches[0].level;
    forAllConstIters(areas, iter)
    {
        largest = iter.val() > areas[largest] ? iter.key() : largest;
    }

    return largest;
}


wordList snappyWalls::baffles() const
{
    DynamicList<word> names;
    for (const snappyPatch& patch : patches)
    {
        if (patch.isBaffle)
        {
            names.append(patch.name);
        }
    }

    return wordList(names);
}


snappyWalls readSnappyWalls
(
    const dictionary& snappy,
    const Time& time,
    remarkList& remarks
)
{
    const dictionary& refined = mandatoryDict
    (
        mandatoryDict(snappy, "castellatedMeshControls"), "refinementSurfaces"
    );
    const dictionary& layers =
        mandatoryDict(mandatoryDict(snappy, "addLayersControls"), "layers");
    const bool isNamed = !snappy.getOrDefault<bool>("singleRegionName", true);
    snappyWalls walls;
    DynamicList<string> missing;
    for (const entry& e : mandatoryDict(snappy, "geometry"))
    {
        const dictionary& geometry = e.dict();
        const word key(e.keyword());
        const word name(geometry.getOrDefault<word>("name", key));
        const dictionary* refinement = refined.findDict(name, keyType::REGEX);
        if (!refinement || isZone(name, *refinement, remarks))
        {
            continue;
        }
        const word type(geometry.get<word>("type"));
        const fileName file(geometry.getOrDefault<fileName>("file", key));
        const fileName path(time.constantPath()/"triSurface"/file);
        if (!type.endsWith("riSurfaceMesh") || !isFile(path))
        {
            missing.append(name + " (" + type + ' ' + file + ')');
            continue;
        }
        const scalar scale = geometry.getOrDefault<scalar>("scale", 1);
        if (walls.files.size() && scale != walls.scale)
        {
            FatalIOErrorInFunction(geometry)
                << "All surfaces must have the same scale: " << name
                << " has the scale " << scale << ", the surfaces before it "
                << walls.scale << nl << "Scale its file:"
                << " surfaceTransformPoints -scale" << exit(FatalIOError);
        }
        walls.scale = scale;
        appendFile
        (
            isFile(path, false) ? path : fileName(path + ".gz"), name,
            geometry, *refinement, isNamed, walls
        );
    }
    requireFiles(walls, missing, layers);
    if (walls.surface.faces.size())
    {
        wallReading reading;
        mergeNearPoints(walls.surface, 0, reading);
    }

    return walls;
}


void checkLocation(const snappyWalls& walls, const point& location)
{
    for (const wallSurface* surface : {&walls.surface, &walls.sheets})
    {
        const scalar tolerance =
            1e-6*boundBox(surface->points, false).mag();
        labelList triangleFace;
        const faceList triangles(wallTriangles(*surface, triangleFace));
        forAll(triangles, i)
        {
            const scalar distance =
                triangles[i].nearestPoint(location, surface->points).distance();
            if (distance > tolerance)
            {
                continue;
            }
            const label patchi = surface->patchIDs[triangleFace[i]];
            FatalErrorInFunction
                << "locationInMesh " << location << " is on the surface: the"
                << " patch " << surface->patchNames[patchi] << " is "
                << distance << " m from it" << nl
                << "Move the point into the fluid" << exit(FatalError);
        }
    }
}


bool isInside
(
    const wallSurface& surface,
    const point& location,
    const blockBox& box
)
{
    if (!isGround(boundBox(surface.points, false), box))
    {
        return isEnclosed(surface, location);
    }

    scalar angle = 0;
    labelList faceOf;
    for (const face& f : wallTriangles(surface, faceOf))
    {
        const pointField& points = surface.points;
        angle += solidAngle
        (
            triPointRef(points[f[0]], points[f[1]], points[f[2]]), location
        );
    }

    return angle > 0.5;
}

} // End namespace Foam

// ************************************************************************* //
