/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismCase.H"
#include "argList.H"
#include "polyMesh.H"
#include "prismPolyMesh.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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


Foam::fileName Foam::prismCase::reportFolder() const
{
    return time_.globalPath()/"postProcessing"/"harmonicPrismMesh"
       /(region_ == polyMesh::defaultRegion ? word::null : region_);
}


Foam::fileName Foam::prismCase::reportFile() const
{
    return reportFolder()/"report";
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
