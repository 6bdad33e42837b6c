/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFuzzCase.H"
#include "equalPoints.H"
#include "isolatedProcess.H"
#include "polyMesh.H"
#include "StringStream.H"
#include "Time.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A face, after those of its points that are not written yet
static void writeFace
(
    std::FILE* out,
    const word& patch,
    const pointField& points,
    equalPoints& labels,
    label& nPoints
)
{
    for (const point& x : points)
    {
        if (labels.insert(x, nPoints))
        {
            std::fprintf(out, "v %.17g %.17g %.17g\n", x.x(), x.y(), x.z());
            ++nPoints;
        }
    }

    std::fprintf(out, "g %s\nf", patch.c_str());
    for (const point& x : points)
    {
        std::fprintf(out, " %d", labels.find(x) + 1);
    }
    std::fprintf(out, "\n");
}


//- Comments that tell the layers
static void writeLayers(std::FILE* out, const layerControls& layers)
{
    std::fprintf
    (
        out,
        "# nSurfaceLayers %d; firstLayerThickness %.17g;"
        " expansionRatio %.17g;\n",
        layers.heights.nSurfaceLayers,
        layers.heights.firstLayerThickness,
        layers.heights.expansionRatio
    );

    if (layers.multipleNormalsAngle > 0)
    {
        std::fprintf
        (
            out, "# multipleNormalsAngle %.17g;\n", layers.multipleNormalsAngle
        );
    }
    for (const patchLayers& other : layers.patches)
    {
        std::fprintf
        (
            out,
            "# patches { %s { %s %.17g; } }\n",
            other.patches.c_str(),
            other.isSide ? "nSurfaceLayers" : "firstLayerThickness",
            other.heights.firstLayerThickness
        );
    }
}


static void writeFaces(std::FILE* out, const wallSurface& surface)
{
    equalPoints labels;
    label nPoints = 0;
    forAll(surface.faces, i)
    {
        writeFace
        (
            out, surface.patchNames[surface.patchIDs[i]],
            pointField(surface.points, surface.faces[i]), labels, nPoints
        );
    }
}


//- The entry boundary of the far field
static dictionary entryOf(const farBoundaryControls& b)
{
    dictionary boundary;
    boundary.add("type", farBoundaryTypes[int(b.type)]);
    if (b.type == farBoundaryType::box)
    {
        boundary.add("min", b.box.min());
        boundary.add("max", b.box.max());
    }
    else
    {
        boundary.add("origin", b.origin);
        boundary.add("radius", b.radius);
    }

    dictionary patches;
    for (const farPatch& patch : b.patches)
    {
        dictionary entry;
        entry.add("type", patch.type);
        entry.add("sides", patch.sides);
        if (patch.cyclic.partner.size())
        {
            entry.add("partner", patch.cyclic.partner);
        }
        patches.add(patch.name, entry);
    }
    boundary.add("patches", patches);

    return boundary;
}


//- The entry farField of the dictionary
static string entryOf(const farFieldControls& controls)
{
    dictionary dict;
    dict.add("type", farFieldTypes[int(controls.type)]);
    dict.add("growthRate", controls.growthRate);
    dict.add("maxCellSize", controls.maxCellSize);
    dict.add("maxCells", controls.maxCells);
    if (controls.type != farFieldType::tet)
    {
        dict.add("gap", controls.gap);
    }

    if (controls.boundary.type != farBoundaryType::none)
    {
        dict.add("boundary", entryOf(controls.boundary));
    }

    dictionary regions;
    for (const sizeRegion& region : controls.regions)
    {
        dictionary entry;
        entry.add("geometry", region.geometry);
        entry.add("mode", word("inside"));
        entry.add("cellSize", region.cellSize);
        regions.add(region.name, entry);
    }
    dict.add("regions", regions);

    OStringStream os;
    os.precision(17);
    dict.writeEntry("farField", os);

    return os.str();
}


//- Comments that tell side planes
static void writePlanes(std::FILE* out, const List<sidePatch>& planes)
{
    for (const sidePatch& side : planes)
    {
        std::fprintf
        (
            out,
            "# %s { point (%.17g %.17g %.17g); normal (%.17g %.17g %.17g); }\n",
            side.name.c_str(), side.origin.x(), side.origin.y(),
            side.origin.z(), side.normal.x(), side.normal.y(), side.normal.z()
        );
    }
}


//- A comment that tells repair, and the side of the fluid
static void writeSurfaceControls
(
    std::FILE* out,
    const wallSurfaceControls& controls
)
{
    const bool isNone =
        controls.repair.repair == surfaceRepairControls::method::none;
    std::fprintf
    (
        out, "# surface { repair %s; fluid %s; }\n",
        isNone ? "none" : "stitch", controls.fluidOutside ? "outside" : "inside"
    );
}


//- A comment that tells the far field
static void writeFarField(std::FILE* out, const farFieldControls& far)
{
    std::istringstream lines(entryOf(far));
    for (std::string line; std::getline(lines, line);)
    {
        std::fprintf(out, "# %s\n", line.c_str());
    }
}


//- The mesh as constant/polyMesh of a case
static void writeCore(const polyMeshParts& core, const fileName& folder)
{
    dictionary control;
    control.add("startFrom", word("startTime"));
    control.add("startTime", 0);
    control.add("endTime", 1);
    control.add("deltaT", 1);
    control.add("writeInterval", 1);
    control.add("writePrecision", 17);
    infoDetailLevel = 0;
    Time time(control, folder.path(), folder.name());

    polyMesh mesh
    (
        IOobject(polyMesh::defaultRegion, time.constant(), time),
        pointField(core.points),
        faceList(core.topology.faces),
        labelList(core.topology.owner),
        labelList(core.topology.neighbour)
    );
    PtrList<polyPatch> patches(core.patches.names.size());
    forAll(patches, patchi)
    {
        dictionary patch(core.patches.entries[patchi]);
        patch.set("nFaces", core.topology.patchSizes[patchi]);
        patch.set("startFace", core.topology.patchStarts[patchi]);
        patches.set
        (
            patchi,
            polyPatch::New
            (
                core.patches.names[patchi], patch, patchi, mesh.boundaryMesh()
            )
        );
    }
    mesh.addPatches(patches);
    mesh.write();
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool Foam::writeSurface(const fuzzCase& one, const fileName& file)
{
    return isolatedProcess
    (
        [&](pipeWriter&)
        {
            const fuzzWall made(makeFuzzWall(one, [](const auto&...) {}));
            const prismLayerControls& controls = made.controls;

            IOstream::defaultPrecision(17);
            std::FILE* out = std::fopen(file.c_str(), "w");
            writeLayers(out, controls.layers);
            writePlanes(out, controls.surface.sidePlanes);
            if (one.hasFarField && made.wall.faces.size())
            {
                const fuzzFarField far
                (
                    one.farField(made.wall, controls.layers)
                );
                writeFarField(out, far.controls);
                if (far.core.nCells)
                {
                    writeCore(far.core, file.lessExt());
                }
            }
            if (one.isAtSides)
            {
                writeSurfaceControls(out, controls.surface);
                writeFarField(out, controls.farField);
            }
            writeFaces(out, made.surface);
            std::fclose(out);
        },
        [](pipeReader&) {},
        60
    ) == processEnd::complete;
}


// ************************************************************************* //
