/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismCase.H"
#include "IOdictionary.H"
#include "argList.H"
#include "OSspecific.H"
#include "partsOfMesh.H"
#include "polyMesh.H"
#include "prismPolyMesh.H"
#include "refusal.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static IOobject dictObject(const argList& args, const Time& time)
{
    return IOobject::selectIO
    (
        IOobject
        (
            "harmonicPrismMeshDict", time.system(), time,
            IOobject::MUST_READ, IOobject::NO_WRITE
        ),
        args.found("dict") ? fileName(args["dict"]) : fileName::null
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::prismCase::prismCase(const argList& args, const Time& time)
:
    time_(time),
    region_(args.lookupOrDefault<word>("region", polyMesh::defaultRegion)),
    overwrite_(args.found("overwrite")),
    dict_(IOdictionary(dictObject(args, time)))
{}


Foam::prismCase::prismCase(const prismCase& all, const word& region)
:
    time_(all.time_),
    region_(region),
    overwrite_(all.overwrite_),
    dict_(all.dict_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::prismCase::checkOverwrite
(
    const UList<fileName>& surfaces,
    const farFieldControls& farField,
    const label nProcesses
) const
{
    const bool replaces =
        overwrite_
     || (farField.type == farFieldType::mesh && farField.region.empty());

    for (const fileName& file : {outerFile(), sidesFile()})
    {
        if (surfaces.found(file))
        {
            FatalErrorInFunction
                << "The run would overwrite the surface " << file << nl
                << "It writes a surface of this name for other meshers. Rename"
                << " the file" << exit(FatalError);
        }
    }

    fileNameList folders(nProcesses);
    forAll(folders, processor)
    {
        folders[processor] = time_.globalPath()
           /("processor" + name(processor))/polyMeshPath();
    }
    if (folders.empty())
    {
        folders.append(polyMeshFolder());
    }

    for (const fileName& folder : folders)
    {
        if (!replaces && isDir(folder))
        {
            FatalErrorInFunction
                << "There is a mesh already: " << folder << nl
                << "Use -overwrite to replace it" << exit(FatalError);
        }
    }
}


Foam::polyMeshParts Foam::prismCase::readCore(const word& region) const
{
    const word name(region.empty() ? region_ : region);
    const fileName folder
    (
        name == polyMesh::defaultRegion
      ? fileName(polyMesh::meshSubDir) : name/polyMesh::meshSubDir
    );

    if (!isFile(time_.path()/time_.constant()/folder/"faces"))
    {
        FatalErrorInFunction
            << "There is no mesh around the layers: "
            << time_.path()/time_.constant()/folder << nl
            << "Make it with blockMesh or snappyHexMesh, or name its region by"
            << " farField.region" << exit(FatalError);
    }

    return partsOf
    (
        polyMesh
        (
            IOobject(name, time_.constant(), time_, IOobject::MUST_READ)
        )
    );
}


Foam::caseSources Foam::prismCase::sources() const
{
    return caseSources
    {
        [this](const fileName& file) { return surfaceFile(file); },
        [this](const word& region) { return readCore(region); },
        time_
    };
}


Foam::IOobject Foam::prismCase::meshObject() const
{
    return IOobject
    (
        region_, time_.constant(), time_,
        IOobject::NO_READ, IOobject::AUTO_WRITE
    );
}


Foam::fileName Foam::prismCase::polyMeshPath() const
{
    return time_.constant()
       /(region_ == polyMesh::defaultRegion ? word::null : region_)
       /polyMesh::meshSubDir;
}


Foam::fileName Foam::prismCase::polyMeshFolder() const
{
    return time_.path()/polyMeshPath();
}


Foam::fileName Foam::prismCase::reportFolder
(
    const Time& time,
    const word& region
)
{
    return time.globalPath()/"postProcessing"/"harmonicPrismMesh"
       /(region == polyMesh::defaultRegion ? word::null : region);
}


Foam::fileName Foam::prismCase::reportFolder() const
{
    return reportFolder(time_, region_);
}


Foam::fileName Foam::prismCase::reportFile() const
{
    return reportFolder()/"report";
}


Foam::fileName Foam::prismCase::jsonFile() const
{
    return reportFile() + ".json";
}


Foam::fileName Foam::prismCase::fieldFolder() const
{
    const fileName fields(time_.globalPath()/"0");

    return
        (isDir(fields) ? fields : fileName(fields + ".orig"))
       /(region_ == polyMesh::defaultRegion ? word::null : region_);
}


void Foam::prismCase::removeRefusal() const
{
    rm(failedPointsFile());
    rm(reportFolder()/refusedName);
}


Foam::fileName Foam::prismCase::regionsFile() const
{
    return time_.globalPath()/time_.constant()/"regionProperties";
}


Foam::fileName Foam::prismCase::failedPointsFile() const
{
    return reportFolder()/"failedPoints.vtk";
}


Foam::fileName Foam::prismCase::surfaceFile(const fileName& name) const
{
    if (name.isAbsolute())
    {
        return name;
    }

    return name.find('/') == std::string::npos
      ? time_.globalPath()/time_.constant()/"triSurface"/name
      : time_.globalPath()/name;
}


Foam::fileNameList Foam::prismCase::surfaceFiles
(
    const wallSurfaceControls& controls
) const
{
    fileNameList files(controls.files);
    for (fileName& file : files)
    {
        file = surfaceFile(file);
    }

    return files;
}


Foam::fileName Foam::prismCase::surfaceOf(const word& name) const
{
    const word stem
    (
        region_ == polyMesh::defaultRegion ? name : word(name + '_' + region_)
    );

    return time_.globalPath()/time_.constant()/"triSurface"/(stem + ".obj");
}


Foam::fileName Foam::prismCase::outerFile() const
{
    return surfaceOf(layerOuterName);
}


Foam::fileName Foam::prismCase::sidesFile() const
{
    return surfaceOf("sides");
}


Foam::fileName Foam::prismCase::preparedFile
(
    const UList<fileName>& surfaces
) const
{
    const fileName& first = surfaces[0];
    const fileName plain(first.ext() == "gz" ? first.lessExt() : first);

    return surfaceFile(plain.nameLessExt() + ".prepared.obj");
}

// ************************************************************************* //
