/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "earlierRun.H"
#include "localIOdictionary.H"
#include "OStringStream.H"
#include "polyMesh.H"
#include "ranges.H"
#include "SubField.H"
#include "surfacePart.H"
#include "throwingErrors.H"
#include "Time.H"
#include "wallPolyPatch.H"

namespace Foam
{

static const word fieldName("yPlus");

//- The zone of the layers, if there are other cells
static const word zoneName("boundaryLayer");


//- The beginning of each error
static OSstream& runError(const fileName& folder)
{
    OSstream& os = FatalErrorInFunction;
    os  << "Cannot take y+ from the case " << folder
        << " of layers.yPlus.from: ";

    return os;
}


static string adviceOnPieces(const fileName& folder)
{
    return isDir(folder/"processor0") || isDir(folder/"processors2")
      ? "\nThe case is decomposed: run reconstructParMesh -constant if the mesh"
        " was, and reconstructPar"
      : "";
}


// * * * * * * * * * * * * * * *  Time and field * * * * * * * * * * * * * * //

//- Sets the time of a run to the one that is asked for
static void setTime(const yPlusRun& run, const fileName& folder, Time& time)
{
    const instantList all(time.times());
    label chosen = -1;

    forAll(all, i)
    {
        const bool isWanted = run.isLatest
          ? isFile(folder/all[i].name()/fieldName)
         || isFile(folder/all[i].name()/fieldName + ".gz")
          : all[i].name() != time.constant() && all[i].equal(run.time);
        chosen = isWanted ? i : chosen;
    }

    if (chosen < 0)
    {
        OStringStream what;
        what<< "time " << run.time;
        runError(folder)
            << "there is no "
            << (run.isLatest ? "time with the field yPlus" : what.str().c_str())
            << nl << "Write the field by: simpleFoam -postProcess -func yPlus"
            << " -latestTime" << adviceOnPieces(folder).c_str()
            << exit(FatalError);
    }

    time.setTime(all[chosen], chosen);
}


//- Returns y+ of a patch.
//  Errors: as readWallsOfRun
static scalarField readYPlus
(
    const dictionary& boundary,
    const polyPatch& patch,
    const fileName& folder,
    const fileName& file
)
{
    scalarField yPlus;
    try
    {
        const throwingErrors throwing(true);
        yPlus = scalarField
        (
            "value", boundary.subDict(patch.name()), patch.size()
        );
    }
    catch (const Foam::error& e)
    {
        runError(folder)
            << "y+ of the patch " << patch.name() << " in " << file
            << " cannot be read for the " << patch.size() << " faces that it"
            << " has in the mesh: " << e.message().c_str() << exit(FatalError);
    }

    forAll(yPlus, i)
    {
        // Written so that a value that is not a number fails
        if (!(yPlus[i] >= 0 && yPlus[i] < GREAT))
        {
            runError(folder)
                << "y+ of the patch " << patch.name() << " in " << file
                << " is " << yPlus[i] << " at " << patch.faceCentres()[i]
                << exit(FatalError);
        }
    }

    if (!(max(yPlus) > 0))
    {
        runError(folder)
            << "y+ of the patch " << patch.name() << " in " << file
            << " is zero everywhere. Has the solver run?" << exit(FatalError);
    }

    return yPlus;
}


//- Where the mesh is that the run has at a time
static word instanceOfMesh(const fileName& folder, const Time& time)
{
    const word instance
    (
        time.findInstance
        (
            polyMesh::meshSubDir, "faces", IOobject::READ_IF_PRESENT
        )
    );
    const fileName meshFolder(folder/instance/polyMesh::meshSubDir);

    if (!isFile(meshFolder/"faces") && !isFile(meshFolder/"faces.gz"))
    {
        runError(folder)
            << "there is no mesh " << meshFolder
            << adviceOnPieces(folder).c_str() << exit(FatalError);
    }

    return instance;
}


// * * * * * * * * * * * * * * * * *  Layers * * * * * * * * * * * * * * * * //

//- Returns the height of a cell on one of its faces.
//  opposite: set to the face of the cell opposite to that face, -1 if there is
//  none
static scalar heightOn
(
    const polyMesh& mesh,
    const label celli,
    const label facei,
    label& opposite
)
{
    opposite = mesh.cells()[celli].opposingFaceLabel(facei, mesh.faces());
    const scalar area = mag(mesh.faceAreas()[facei]);

    return opposite >= 0
      ? 2*mesh.cellVolumes()[celli]/(area + mag(mesh.faceAreas()[opposite]))
      : 2*mag
        (
            (mesh.cellCentres()[celli] - mesh.faceCentres()[facei])
          & mesh.faceAreas()[facei]
        )/area;
}


//- Adds a face of the mesh, with the height of the first layer and the sum of
//  the heights. A column ends at a cell that is no prism, or in no layer.
static void addHeights
(
    const polyMesh& mesh,
    const label facei,
    DynamicList<scalar>& first,
    DynamicList<scalar>& total
)
{
    const label zonei = mesh.cellZones().findZoneID(zoneName);
    label celli = mesh.faceOwner()[facei];
    label opposite = -1;
    first.append(heightOn(mesh, celli, facei, opposite));
    total.append(first.last());

    while
    (
        opposite >= 0 && mesh.isInternalFace(opposite)
     && (zonei < 0 || mesh.cellZones().whichZone(celli) == zonei)
    )
    {
        const label below = opposite;
        celli = mesh.faceOwner()[below] == celli
          ? mesh.faceNeighbour()[below] : mesh.faceOwner()[below];

        if (zonei >= 0 && mesh.cellZones().whichZone(celli) != zonei)
        {
            break;
        }

        const scalar height = heightOn(mesh, celli, below, opposite);
        total.last() += opposite >= 0 ? height : 0;
    }
}


//- Adds a patch, all of whose points are points of the mesh yet
static void addPatch
(
    const polyMesh& mesh,
    const polyPatch& patch,
    const scalarField& yPlus,
    wallsOfRun& walls
)
{
    DynamicList<scalar> first(patch.size());
    DynamicList<scalar> total(patch.size());
    faceList faces(patch.size());

    forAll(patch, i)
    {
        addHeights(mesh, patch.start() + i, first, total);

        // Normals of patches point out of the mesh
        faces[i] = patch[i].reverseFace();
    }

    wallSurface& surface = walls.surface;
    surface.faces.append(faces);
    surface.patchIDs.append
    (
        labelList(patch.size(), surface.patchNames.size())
    );
    surface.patchNames.append(patch.name());
    walls.yPlus.append(yPlus);
    walls.firstHeight.append(scalarField(first));
    walls.thickness.append(scalarField(total));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallsOfRun readWallsOfRun
(
    const yPlusRun& run,
    const fileName& folder,
    const wordList& patchNames
)
{
    if (!isDir(folder))
    {
        runError(folder) << "there is no such folder" << exit(FatalError);
    }

    Time time(folder.path(), folder.name(), "system", "constant", false, false);
    setTime(run, folder, time);

    const word instance(instanceOfMesh(folder, time));
    const polyMesh mesh
    (
        IOobject(polyMesh::defaultRegion, instance, time, IOobject::MUST_READ)
    );
    const IOobject field
    (
        fieldName, time.timeName(), time, IOobject::MUST_READ,
        IOobject::NO_WRITE, false
    );
    const localIOdictionary dict(field, "volScalarField");
    const dictionary& boundary = dict.subDict("boundaryField");

    wallsOfRun walls;
    walls.time = time.timeName();
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if
        (
            patch.size() && patchNames.found(patch.name())
         && isA<wallPolyPatch>(patch)
        )
        {
            const scalarField yPlus
            (
                readYPlus(boundary, patch, folder, field.objectPath())
            );
            addPatch(mesh, patch, yPlus, walls);
        }
    }

    if (walls.yPlus.empty())
    {
        runError(folder)
            << "its mesh has none of the walls "
            << listed(patchNames).c_str() << nl << "Its patches: "
            << listed(mesh.boundaryMesh().names()).c_str() << exit(FatalError);
    }
    walls.surface.points = mesh.points();
    removeUnusedPoints(walls.surface.faces, walls.surface.points);

    return walls;
}

} // End namespace Foam

// ************************************************************************* //
