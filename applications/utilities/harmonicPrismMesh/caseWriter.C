/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseWriter.H"
#include "fieldNames.H"
#include "layerReport.H"
#include "ListOps.H"
#include "meshFiles.H"
#include "meshPiece.H"
#include "polyMesh.H"
#include "prismCase.H"
#include "prismPolyMesh.H"
#include "prismQuality.H"
#include "sidePatchRemainders.H"
#include "throwingErrors.H"
#include "Time.H"
#include "wedgeMesh.H"
#include "writeObj.H"

namespace Foam
{

MeshedSurface<face> toMeshedSurface(const wallSurface& surface)
{
    const labelListList patchFaces
    (
        invertOneToMany(surface.patchNames.size(), surface.patchIDs)
    );
    faceList faces;
    List<surfZone> zones(patchFaces.size());

    forAll(patchFaces, patchi)
    {
        zones[patchi] = surfZone
        (
            surface.patchNames[patchi], patchFaces[patchi].size(),
            faces.size(), patchi
        );
        faces.append(UIndirectList<face>(surface.faces, patchFaces[patchi])());
    }

    return MeshedSurface<face>
    (
        pointField(surface.points), std::move(faces), zones
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * *  Case Writer  * * * * * * * * * * * * * * * //

namespace Foam
{

//- The end of the last line of OpenFOAM's files
static const char* const dividerEnd = "* //";

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::caseWriter::caseWriter
(
    const prismCase& files,
    const parallelRun& parallel,
    Time& time
)
:
    case_(files),
    parallel_(parallel),
    time_(time)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::caseWriter::writeFaces
(
    const fileName& target,
    const MeshedSurface<face>& surface,
    replacedFiles& files
) const
{
    const word name(target.name());
    const fileName file(files.scratch(target, name)/name);

    writeObj(file, surface);
    checkEnd(file, objEnd);
}


void Foam::caseWriter::writeSurface
(
    const fileName& target,
    const wallSurface& surface,
    replacedFiles& files
) const
{
    writeFaces(target, toMeshedSurface(surface), files);
}


void Foam::caseWriter::writeSurfaces
(
    const prismLayers& layers,
    const bool hasFarField,
    replacedFiles& files
) const
{
    wallSurface outer(outerPolygons(layers));
    outer.patchNames = wordList(1, layerOuterName);
    outer.patchIDs = labelList(outer.faces.size(), 0);
    writeSurface(case_.outerFile(), outer, files);

    const List<sidePatch>& sides = layers.border.sides;
    if (!hasFarField && sides.size() && !hasPlanes(sides))
    {
        const farFieldBoundary rest
        (
            makeFarFieldBoundary
            (
                layers, farBoundary(), [](const point&) { return GREAT; }
            )
        );
        writeSurface(case_.sidesFile(), rest.surface, files);
    }
}


Foam::dictionary Foam::caseWriter::compareWithFields
(
    const prismCase& region,
    const replacedFiles& files
) const
{
    const fileName folder(region.fieldFolder());
    if (!isDir(folder))
    {
        return dictionary();
    }
    const List<fieldNames> fields
    (
        compareFields
        (
            readPatches(files.written(region.polyMeshFolder())/"boundary"),
            folder
        )
    );
    write(Info, fields);

    return toDictionary(fields);
}


void Foam::caseWriter::writeReports
(
    const prismCase& region,
    const dictionary& entries,
    replacedFiles& files
) const
{
    IOstream::defaultPrecision(6);
    for (const fileName& file : {region.reportFile(), region.jsonFile()})
    {
        writeReport(files.scratch(file, file.name())/file.name(), entries);
    }
}


void Foam::caseWriter::writeMeshFolder
(
    const prismCase& region,
    replacedFiles& files,
    const std::function<void(const IOobject&)>& write
) const
{
    // The scratch folder is the case while the mesh is written
    const fileName scratch
    (
        files.scratch(region.polyMeshFolder(), region.polyMeshPath())
    );
    const fileName caseName(time_.caseName());
    time_.caseName() = scratch.relative(time_.rootPath());
    write(region.meshObject());
    time_.caseName() = caseName;

    // OpenFOAM does not look whether the last bytes of a file arrived
    const fileName folder(scratch/region.polyMeshPath());
    for (const fileName& file : readDir(folder, fileName::FILE))
    {
        checkEnd(folder/file, dividerEnd);
    }
}


Foam::label Foam::caseWriter::writeMesh
(
    const prismCase& region,
    const meshInBlocks& mesh,
    const planarControls& planar,
    replacedFiles& files
) const
{
    label nFaces = mesh.nFaces();
    const auto write = [&](const IOobject& io)
    {
        if (planar.wedgeAngle > 0)
        {
            autoPtr<polyMesh> wedge(makePolyMesh(partsOf(mesh), io));
            makeWedge(planar, *wedge);
            writeWhole(*wedge);
            nFaces = wedge->nFaces();
        }
        else
        {
            Foam::writeMesh(mesh, io);
        }
    };
    writeMeshFolder(region, files, write);

    return nFaces;
}


void Foam::caseWriter::requireDivisible(const meshInBlocks& mesh) const
{
    string name;
    for (const faceZoneParts& zone : mesh.faceZones)
    {
        name = "faceZone " + zone.name;
    }
    const polyMesh frame
    (
        case_.meshObject(), pointField(), faceList(), labelList(), labelList(),
        false
    );
    forAll(mesh.patches.names, i)
    {
        dictionary entries(mesh.patches.entries[i]);
        entries.set("nFaces", 0);
        entries.set("startFace", 0);
        const word& patch = mesh.patches.names[i];
        if (polyPatch::New(patch, entries, i, frame.boundaryMesh())->coupled())
        {
            name = "coupled patch " + patch;
        }
    }

    if (name.size())
    {
        FatalErrorInFunction
            << "The mesh has the " << name.c_str() << ". A run in parallel"
            << " cannot write it" << nl
            << "Run without -parallel, then decomposePar"
            << exit(FatalError);
    }
}


Foam::string Foam::caseWriter::writePieces
(
    const meshPiece& piece,
    replacedFiles& files
) const
{
    string failure;
    const throwingErrors throwing(true);
    try
    {
        writeMeshFolder
        (
            case_, files, [&](const IOobject& io) { writeMeshPiece(piece, io); }
        );
    }
    catch (const Foam::error& e)
    {
        failure = e.message();
    }

    return parallel_.firstFailure(failure);
}


void Foam::caseWriter::writeOwn
(
    const meshPiece& piece,
    replacedFiles& files
) const
{
    const string failure(writePieces(piece, files));
    if (failure.size())
    {
        FatalErrorInFunction << failure.c_str() << exit(FatalError);
    }
}


bool Foam::caseWriter::writeOnOther(const meshPiece& piece) const
{
    replacedFiles files;
    IOstream::defaultPrecision(17);
    const bool isWell = writePieces(piece, files).empty();
    if (isWell)
    {
        files.replaceAll();
    }
    else
    {
        files.removeScratch();
    }

    return isWell;
}

// ************************************************************************* //
