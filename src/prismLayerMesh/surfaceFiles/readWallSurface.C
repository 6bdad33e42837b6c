/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readWallSurface.H"
#include "cadSurface.H"
#include "cutReflexFaces.H"
#include "mergeNearPoints.H"
#include "orientWallSurface.H"
#include "surfacePart.H"
#include "surfaceFile.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void checkFinite(const fileName& file, const pointField& points)
{
    forAll(points, i)
    {
        for (direction d = 0; d < 3; ++d)
        {
            // Larger ones overflow in areas and volumes; isless because < on
            // NaN ends the process where floating-point exceptions do
            if (!std::isless(mag(points[i][d]), 1e90))
            {
                FatalErrorInFunction
                    << "Cannot use the surface " << file << ": point " << i
                    << " at " << points[i] << " is not finite"
                    << exit(FatalError);
            }
        }
    }
}


//- Give patches valid names. If there is but one and the file has not named it,
//  it is named after the file.
static void namePatches(wallSurface& wall, const fileName& file)
{
    for (word& name : wall.patchNames)
    {
        name = word::validate(name, true);
    }

    const wordList unnamed({"", "zone0", "solid", "solid0", "patch0"});

    if (wall.patchNames.size() == 1 && unnamed.found(wall.patchNames[0]))
    {
        const fileName plain(file.ext() == "gz" ? file.lessExt() : file);
        const word stem(word::validate(plain.nameLessExt(), true));
        wall.patchNames[0] = (stem.empty() ? word("wall") : stem);
    }
}


//- A file as it is, scaled
static wallSurface readPart
(
    const fileName& file,
    const wallSurfaceControls& controls,
    bool& separateFaces,
    wallReading& reading
)
{
    wallSurface part;

    if (cadType(file).size())
    {
        string remark;
        typedef surfaceRepairControls::method method;
        const bool unite =
            controls.fluidOutside && controls.repair.repair == method::stitch;
        const scalar scale = controls.scale;
        part = readCadSurface(file, controls.cad, unite, scale, remark);
        reading.cadFiles.append(file.name() + ": " + remark);
    }
    else
    {
        part = readSurfaceFile(file, separateFaces);
    }
    part.points *= controls.scale;
    checkFinite(file, part.points);
    mergePatches(part);
    namePatches(part, file);

    return part;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallSurface readWallSurface
(
    const UList<fileName>& files,
    const wallSurfaceControls& controls,
    wallReading& reading
)
{
    reading = wallReading();
    bool separateFaces = files.size() > 1;
    wallSurface wall;

    for (const fileName& file : files)
    {
        bool separate = false;
        wallSurface part(readPart(file, controls, separate, reading));
        separateFaces = separateFaces || separate;

        if (files.size() == 1)
        {
            wall = std::move(part);
        }
        else
        {
            appendSurface(part, labelList(), wall);
        }
    }

    if (separateFaces)
    {
        mergeNearPoints(wall, controls.mergeTolerance, reading);
    }

    removeUnusedPoints(wall.faces, wall.points);
    mergePatches(wall);
    reading.cutFaces = cutReflexFaces(wall);
    if (files.size() > 1 || reading.cadFiles.size())
    {
        orientAlike(wall);
    }
    reading.flippedFaces = orientWallSurface(wall, controls.fluidOutside);

    return wall;
}

} // End namespace Foam

// ************************************************************************* //
