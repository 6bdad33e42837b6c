/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismCase.H"
#include "prismPolyMesh.H"
#include "replacedFiles.H"
#include "Time.H"
#include "writeObjects.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The end of the last line of OpenFOAM's files
static const char* const dividerEnd = "* //";


//- Pieces have neither face zones nor patches with something on another side
static void refuseCoupled(const polyMesh& mesh)
{
    string name;
    for (const faceZone& zone : mesh.faceZones())
    {
        name = "faceZone " + zone.name();
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.coupled())
        {
            name = "coupled patch " + patch.name();
        }
    }

    if (name.size())
    {
        FatalErrorInFunction
            << "The mesh has the " << name.c_str() << ", and pieces of a mesh"
            << " have none" << nl
            << "Make it in one process, and decompose it then"
            << exit(FatalError);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::prismCase::writeMesh
(
    const polyMesh& mesh,
    const meshPiece* piece,
    replacedFiles& files
) const
{
    // The scratch folder is the case while the mesh is written
    const fileName scratch(files.scratch(polyMeshFolder(), polyMeshPath()));
    const fileName caseName(time_.caseName());
    time_.caseName() = scratch.relative(time_.rootPath());
    const bool written =
        writeObjects(mesh) && (!piece || writeAddressing(mesh, *piece));
    time_.caseName() = caseName;

    if (!written)
    {
        FatalErrorInFunction << "Cannot write to it" << exit(FatalError);
    }

    // OpenFOAM does not look whether the last bytes of a file arrived
    const fileName folder(scratch/polyMeshPath());
    for (const fileName& file : readDir(folder, fileName::FILE))
    {
        checkEnd(folder/file, dividerEnd);
    }
}


void Foam::prismCase::writePiece(meshPiece& piece, replacedFiles& files) const
{
    const autoPtr<polyMesh> mesh
    (
        makePolyMesh(meshObject(), team_.processor(), piece)
    );
    writeMesh(mesh(), &piece, files);
}


Foam::autoPtr<Foam::polyMesh> Foam::prismCase::writeMesh
(
    prismLayers& layers,
    farFieldMesh& far,
    replacedFiles& files
) const
{
    const label nStacks = layers.faces.size();
    const label nLayers = layers.nLayers;
    autoPtr<polyMesh> mesh;

    if (!team_.isParallel() || !far.empty())
    {
        mesh = makePrismPolyMesh(layers, far, meshObject());
    }

    if (team_.isParallel())
    {
        if (mesh)
        {
            refuseCoupled(*mesh);
        }
        meshPiece piece
        (
            mesh
          ? team_.sendPieces(mesh(), nStacks, nLayers)
          : team_.sendPieces(layers)
        );
        writePiece(piece, files);
        team_.requireWritten();
    }
    else
    {
        writeMesh(mesh(), nullptr, files);
    }

    return mesh;
}


// ************************************************************************* //
