/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh.H"
#include "HashSet.H"
#include "labelIOList.H"
#include "meshFiles.H"
#include "meshOrder.H"
#include "meshPiece.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const word layerOuterName("layerOuter");
const word layerSidesName("layerSides");


static const word& typeOfSide(const wallBorder& border, const word& name)
{
    for (const sidePatch& side : border.sides)
    {
        if (side.name == name)
        {
            return side.type;
        }
    }

    return word::null;
}


//- The patches of the wall, with names and entries of those that they replace
static meshPatches patchesOfWall
(
    const prismLayers& layers,
    const meshPatches& replaced = meshPatches()
)
{
    wordList names(layers.patchNames);
    forAll(replaced.names, patchi)
    {
        if (replaced.names[patchi].size())
        {
            names[patchi] = replaced.names[patchi];
        }
    }
    names = prismPatchNames(names);

    meshPatches wall;
    forAll(names, patchi)
    {
        wall.append
        (
            names[patchi],
            patchi < layers.patchTypes.size()
          ? layers.patchTypes[patchi] : word("wall")
        );
        if (patchi < replaced.names.size() && replaced.names[patchi].size())
        {
            wall.entries[patchi] = replaced.entries[patchi];
        }
    }

    return wall;
}


//- Leaves out patches of an existing mesh that have lost all faces to the wall
//  and whose names the wall has
static void dropPatchesOfWall(const wordList& wallPatches, farFieldMesh& far)
{
    DynamicList<label> kept;
    forAll(far.patches.names, patchi)
    {
        const word& name = far.patches.names[patchi];
        const label size = far.topology.patchSizes[1 + patchi];

        if (!wallPatches.found(name))
        {
            kept.append(patchi);
        }
        else if (size)
        {
            FatalErrorInFunction
                << "The wall and the mesh around the layers both have a patch "
                << name << ", and " << size << " faces of the mesh's patch"
                << " stay." << nl << "Rename one of the patches"
                << exit(FatalError);
        }
    }

    far.keepPatches(kept);
}


wordList prismPatchNames(const wordList& wallPatchNames)
{
    wordHashSet taken;
    taken.insert(layerOuterName);
    taken.insert(layerSidesName);

    wordList names(wallPatchNames);

    for (word& name : names)
    {
        const word asGiven(name);

        for (label i = 2; !taken.insert(name); ++i)
        {
            name = asGiven + Foam::name(i);
        }
    }

    return names;
}


//- Returns the patches of the mesh of layers without a far field.
//  nOpen: number of lists of openEdges
static meshPatches patchesOfLayers(const prismLayers& layers, const label nOpen)
{
    meshPatches patches(patchesOfWall(layers));

    patches.append(layerOuterName, "patch");
    const wordList sides(sidePatchNames(layers.border));
    for (const word& name : sides)
    {
        patches.append(name, typeOfSide(layers.border, name));
    }
    setCyclic(layers.border.sides, patches);
    if (nOpen > sides.size())
    {
        patches.append(layerSidesName, "patch");
    }

    return patches;
}


meshPatches patchesOfMesh
(
    const prismLayers& layers,
    const label nOpen,
    farFieldMesh& far
)
{
    if (far.empty())
    {
        return patchesOfLayers(layers, nOpen);
    }

    meshPatches patches(patchesOfWall(layers, far.replaced));
    dropPatchesOfWall(patches.names, far);
    patches.names.append(far.patches.names);
    patches.entries.append(far.patches.entries);

    return patches;
}


List<labelPair> partsOfPatches
(
    const prismLayers& layers,
    const label nOpen,
    const farFieldMesh& far
)
{
    const label nWall = layers.patchNames.size();
    const wordList sideNames(sidePatchNames(layers.border));
    DynamicList<labelPair> parts;
    for (label i = 0; i < (far.empty() ? nWall + 1 + nOpen : nWall); ++i)
    {
        parts.append(labelPair(i, -1));
    }
    forAll(far.patches.names, i)
    {
        // The sides of layers follow the wall and the outer surface
        const label side = sideNames.find(far.patches.names[i]);
        parts.append(labelPair(side < 0 ? -1 : nWall + 1 + side, 1 + i));
    }

    return List<labelPair>(std::move(parts));
}


// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const word boundaryLayerName("boundaryLayer");


static void addZones
(
    const UList<cellZoneParts>& cellZones,
    const UList<faceZoneParts>& faceZones,
    polyMesh& mesh
)
{
    List<cellZone*> cells;
    for (const cellZoneParts& zone : cellZones)
    {
        cells.append
        (
            new cellZone
            (
                zone.name, zone.cells, cells.size(), mesh.cellZones()
            )
        );
    }
    List<faceZone*> faces;
    for (const faceZoneParts& zone : faceZones)
    {
        faces.append
        (
            new faceZone
            (
                zone.name, zone.faces, zone.flips, faces.size(),
                mesh.faceZones()
            )
        );
    }
    mesh.addZones(List<pointZone*>(), faces, cells);
}


//- Returns a mesh with patches and zones. It is made, not read, whatever io
//  says.
//  points: if there are none, the mesh is a frame for the files of patches and
//  zones
//  all, patchStarts: see meshInBlocks
static autoPtr<polyMesh> makeMesh
(
    const IOobject& io,
    pointField&& points,
    polyMeshTopology&& topology,
    const meshPatches& all,
    const labelUList& patchStarts,
    const UList<cellZoneParts>& cellZones,
    const UList<faceZoneParts>& faceZones
)
{
    const bool isWhole = points.size();
    IOobject unread(io);
    unread.readOpt() = IOobject::NO_READ;
    autoPtr<polyMesh> mesh
    (
        new polyMesh
        (
            unread,
            std::move(points),
            faceList(std::move(topology.faces)),
            labelList(std::move(topology.owner)),
            labelList(std::move(topology.neighbour)),
            false
        )
    );

    PtrList<polyPatch> patches(all.names.size());
    forAll(patches, patchi)
    {
        dictionary patch(all.entries[patchi]);
        patch.set("nFaces", patchStarts[patchi + 1] - patchStarts[patchi]);
        patch.set("startFace", patchStarts[patchi]);
        patches.set
        (
            patchi,
            polyPatch::New
            (
                all.names[patchi], patch, patchi, mesh->boundaryMesh()
            )
        );
    }
    mesh->addPatches(patches, isWhole);
    addZones(cellZones, faceZones, *mesh);

    return mesh;
}


//- Writes the files of a mesh. Returns the mesh without points and faces.
static autoPtr<polyMesh> writeFiles
(
    const meshInBlocks& mesh,
    const IOobject& io
)
{
    // Zones of faces look whether they have labels of faces
    polyMeshTopology nothing;
    nothing.faces.setSize(mesh.faceZones.size() ? mesh.nFaces() : 0);
    nothing.owner.setSize(nothing.faces.size(), 0);
    autoPtr<polyMesh> frame
    (
        makeMesh
        (
            io, pointField(), std::move(nothing), mesh.patches,
            mesh.patchStarts, mesh.cellZones, mesh.faceZones
        )
    );
    writeMeshFiles(*frame, mesh);

    return frame;
}


polyMeshTopology makePrismTopology(const prismLayers& layers)
{
    farFieldMesh none;

    return partsOf(meshOrder(layers, none).mesh()).topology;
}


autoPtr<polyMesh> makePrismPolyMesh
(
    const prismLayers& layers,
    farFieldMesh& far,
    const IOobject& io
)
{
    return makePolyMesh(partsOf(meshOrder(layers, far).mesh()), io);
}


//- The far field of a wall, with the patches of the wall in place of the patch
//  on the layers
static polyMeshParts makeWallMeshParts
(
    const prismLayers& wall,
    farFieldMesh& far
)
{
    polyMeshParts mesh;
    mesh.patches = patchesOfMesh(wall, 0, far);
    mesh.points = std::move(far.points);
    mesh.nCells = far.nCells;

    mesh.topology = std::move(far.topology);

    const polyMeshTopology& t = mesh.topology;
    List<DynamicList<label>> onWall(wall.patchNames.size());
    forAll(far.frontFaces, k)
    {
        onWall[wall.patchIDs[far.frontFaces[k]]].append(t.patchStarts[0] + k);
    }
    DynamicList<labelList> facesOf;
    for (const DynamicList<label>& faces : onWall)
    {
        facesOf.append(faces);
    }
    for (label patchi = 1; patchi < t.patchStarts.size(); ++patchi)
    {
        facesOf.append(t.patchFaces(patchi).labels());
    }
    mesh.topology.setPatches(facesOf);

    return mesh;
}


polyMeshParts makePrismMeshParts(const prismLayers& layers, farFieldMesh& far)
{
    if (layers.nLayers == 0)
    {
        return makeWallMeshParts(layers, far);
    }

    const meshOrder order(layers, far);
    polyMeshParts mesh(partsOf(order.mesh()));
    mesh.cellZones.clear();
    mesh.faceZones.clear();

    return mesh;
}


autoPtr<polyMesh> makePolyMesh(polyMeshParts&& parts, const IOobject& io)
{
    labelList starts(parts.topology.patchStarts);
    starts.append(parts.topology.faces.size());

    return makeMesh
    (
        io, std::move(parts.points), std::move(parts.topology), parts.patches,
        starts, parts.cellZones, parts.faceZones
    );
}


void writeMesh(const meshInBlocks& mesh, const IOobject& io)
{
    writeFiles(mesh, io);
}


void writeMeshPiece(const meshPiece& piece, const IOobject& io)
{
    const autoPtr<polyMesh> frame(writeFiles(blocksOf(piece), io));
    const auto write = [&](const char* name, const labelUList& labels)
    {
        const IOobject object
        (
            name, frame->facesInstance(), polyMesh::meshSubDir, frame(),
            IOobject::NO_READ, IOobject::NO_WRITE, false
        );
        writeWhole(labelIOList(object, labelList(labels)));
    };
    labelList patches(identity(piece.patchNames.size()));
    patches.append(labelList(piece.others.size(), -1));

    write("cellProcAddressing", piece.cellAddressing);
    write("faceProcAddressing", piece.faces.addressing);
    write("pointProcAddressing", piece.pointAddressing);
    write("boundaryProcAddressing", patches);
}

} // End namespace Foam

// ************************************************************************* //
