/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh.H"
#include "HashSet.H"
#include "labelIOList.H"
#include "meshFiles.H"
#include "meshOrder.H"
#include "prismFaces.H"
#include "processorPolyPatch.H"

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


//- Returns a mesh without patches. It is made, not read, whatever io says.
static autoPtr<polyMesh> meshWithoutPatches
(
    const IOobject& io,
    pointField&& points,
    polyMeshTopology&& topology
)
{
    IOobject unread(io);
    unread.readOpt() = IOobject::NO_READ;

    return autoPtr<polyMesh>
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
}


//- Returns the patches of a mesh.
//  starts: the first face of each patch, and then the first face behind them
static PtrList<polyPatch> makePatches
(
    const meshPatches& all,
    const labelUList& starts,
    const polyBoundaryMesh& boundary
)
{
    PtrList<polyPatch> patches(all.names.size());
    forAll(patches, patchi)
    {
        dictionary patch(all.entries[patchi]);
        patch.set("nFaces", starts[patchi + 1] - starts[patchi]);
        patch.set("startFace", starts[patchi]);
        patches.set
        (
            patchi, polyPatch::New(all.names[patchi], patch, patchi, boundary)
        );
    }

    return patches;
}


//- Adds the patches of the whole mesh, then those to other processes.
//  process: of the piece
static void addPatches
(
    const meshOrder& order,
    const meshPatches& all,
    const label process,
    const bool isWhole,
    polyMesh& mesh
)
{
    const polyBoundaryMesh& boundary = mesh.boundaryMesh();
    const labelList starts(order.patchStarts());
    PtrList<polyPatch> patches(makePatches(all, starts, boundary));

    label start = starts.last();
    for (const labelPair& other : order.facesToProcesses())
    {
        patches.append
        (
            new processorPolyPatch
            (
                other.second(), start, patches.size(), boundary, process,
                other.first()
            )
        );
        start += other.second();
    }

    mesh.addPatches(patches, isWhole);
}


//- The cells of a zone of the far field in the mesh, where they follow those of
//  the layers
static labelList cellsOf(const prismLayers& layers, const cellZoneParts& zone)
{
    const label n = layers.nLayers;
    DynamicList<label> cells(zone.frontFaces.size()*n + zone.cells.size());
    for (const label fronti : zone.frontFaces)
    {
        for (label i = 1; i <= n; ++i)
        {
            cells.append(cellLabel(layers, fronti, i));
        }
    }
    for (const label celli : zone.cells)
    {
        cells.append(layers.faces.size()*n + celli);
    }

    return labelList(std::move(cells));
}


//- Adds the zones of a mesh with a far field.
//  hasLayers: whether the whole mesh has stacks of layers
static void addZones
(
    const prismLayers& layers,
    const farFieldMesh& far,
    const meshOrder& order,
    const bool hasLayers,
    polyMesh& mesh
)
{
    List<cellZone*> cells;
    List<faceZone*> faces;
    if (hasLayers)
    {
        cells.append
        (
            new cellZone
            (
                boundaryLayerName,
                identity(layers.faces.size()*layers.nLayers), 0,
                mesh.cellZones()
            )
        );
    }

    for (const cellZoneParts& zone : far.cellZones)
    {
        cells.append
        (
            new cellZone
            (
                zone.name, cellsOf(layers, zone), cells.size(), mesh.cellZones()
            )
        );
    }

    const labelList newFaces
    (
        far.faceZones.size() ? order.farFaceLabels() : labelList()
    );
    for (const faceZoneParts& zone : far.faceZones)
    {
        labelList labels(zone.faces);
        inplaceRenumber(newFaces, labels);
        faces.append
        (
            new faceZone
            (
                zone.name, labels, zone.flips, faces.size(), mesh.faceZones()
            )
        );
    }

    mesh.addZones(List<pointZone*>(), faces, cells);
}


//- Copies a block of faces to its place in a mesh
static void copyFaces
(
    const faceBlock& block,
    const label firstFace,
    const label firstInternal,
    polyMeshTopology& mesh
)
{
    forAll(block.ends, i)
    {
        mesh.faces[firstFace + i] = face(block.face(i));
        mesh.owner[firstFace + i] = block.owner[i];
    }
    forAll(block.neighbour, i)
    {
        mesh.neighbour[firstInternal + i] = block.neighbour[i];
    }
}


//- The faces of a mesh of layers and far field
static polyMeshTopology makeTopology(const meshOrder& order)
{
    const meshBlocks& blocks = order.blocks();
    polyMeshTopology mesh;
    mesh.faces.setSize(blocks.nFaces());
    mesh.owner.setSize(blocks.nFaces());
    mesh.neighbour.setSize(blocks.nInternalFaces());

    #pragma omp parallel for schedule(dynamic)
    for (label i = 0; i < blocks.nFaceBlocks; ++i)
    {
        copyFaces
        (
            blocks.faces(i), blocks.firstFaces[i], blocks.firstInternal[i], mesh
        );
    }

    mesh.patchStarts = order.patchStarts();
    const label nPatches = mesh.patchStarts.size() - 1;
    mesh.patchSizes.setSize(nPatches);
    forAll(mesh.patchSizes, patchi)
    {
        mesh.patchSizes[patchi] =
            mesh.patchStarts[patchi + 1] - mesh.patchStarts[patchi];
    }
    mesh.patchStarts.setSize(nPatches);

    return mesh;
}


namespace
{

//- The mesh of layers and far field before it is a polyMesh, or files
struct prismMesh
{
    const prismLayers& layers;
    const farFieldMesh& far;
    labelListList faceNeighbours;
    List<DynamicList<labelPair>> open;
    meshPatches patches;
    meshOrder order;
    const label process = 0;
    const bool hasLayers = true;

    prismMesh(const prismLayers& l, farFieldMesh& f)
    :
        layers(l),
        far(f),
        faceNeighbours(findFaceNeighbours(l)),
        open(openEdges(l, faceNeighbours)),
        patches(patchesOfMesh(l, open.size(), f)),
        order
        (
            l, f, std::move(faceNeighbours), open,
            partsOfPatches(l, open.size(), f)
        )
    {}

    explicit prismMesh(const meshPiece& piece)
    :
        layers(piece.layers),
        far(piece.far),
        patches(piece.patches),
        order(piece),
        process(piece.process),
        hasLayers(piece.nStacks > 0)
    {}

    //- Makes the mesh with patches and zones.
    //  points, topology: of the mesh. Without points patches and zones alone
    //  are made.
    autoPtr<polyMesh> make
    (
        const IOobject& io,
        pointField&& points,
        polyMeshTopology&& topology
    ) const
    {
        const bool isWhole = points.size();
        autoPtr<polyMesh> mesh
        (
            meshWithoutPatches(io, std::move(points), std::move(topology))
        );
        addPatches(order, patches, process, isWhole, mesh());
        if (far.topology.patchSizes.size())
        {
            addZones(layers, far, order, hasLayers, mesh());
        }

        return mesh;
    }

    //- Writes the files. Returns the mesh without points and faces.
    autoPtr<polyMesh> write(const IOobject& io) const
    {
        // Zones of faces look whether they have labels of faces
        polyMeshTopology nothing;
        nothing.faces.setSize
        (
            far.faceZones.size() ? order.blocks().nFaces() : 0
        );
        nothing.owner.setSize(nothing.faces.size(), 0);
        autoPtr<polyMesh> frame(make(io, pointField(), std::move(nothing)));
        writeMeshFiles(frame(), order.blocks());

        return frame;
    }
};

} // End anonymous namespace


polyMeshTopology makePrismTopology(const prismLayers& layers)
{
    farFieldMesh none;

    return makeTopology(prismMesh(layers, none).order);
}


autoPtr<polyMesh> makePrismPolyMesh
(
    const prismLayers& layers,
    farFieldMesh& far,
    const IOobject& io
)
{
    const prismMesh mesh(layers, far);

    return mesh.make
    (
        io, mesh.order.blocks().allPoints(), makeTopology(mesh.order)
    );
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

    const polyMeshTopology& t = far.topology;
    List<labelList> facesOf(wall.patchNames.size());
    {
        List<DynamicList<label>> onWall(facesOf.size());
        forAll(far.frontFaces, k)
        {
            onWall[wall.patchIDs[far.frontFaces[k]]].append
            (
                t.patchStarts[0] + k
            );
        }
        forAll(facesOf, patchi)
        {
            facesOf[patchi] = onWall[patchi];
        }
    }
    for (label patchi = 1; patchi < t.patchStarts.size(); ++patchi)
    {
        facesOf.append
        (
            identity(t.patchSizes[patchi], t.patchStarts[patchi])
        );
    }
    mesh.topology = withPatches(t, facesOf);

    return mesh;
}


polyMeshParts makePrismMeshParts(const prismLayers& layers, farFieldMesh& far)
{
    if (layers.nLayers == 0)
    {
        return makeWallMeshParts(layers, far);
    }

    const prismMesh made(layers, far);
    polyMeshParts mesh;
    mesh.points = made.order.blocks().allPoints();
    mesh.nCells = made.order.blocks().nCells;
    mesh.topology = makeTopology(made.order);
    mesh.patches = made.patches;

    return mesh;
}


static void addZones(const polyMeshParts& parts, polyMesh& mesh)
{
    List<cellZone*> cells;
    for (const cellZoneParts& zone : parts.cellZones)
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
    for (const faceZoneParts& zone : parts.faceZones)
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


autoPtr<polyMesh> makePolyMesh(polyMeshParts&& parts, const IOobject& io)
{
    labelList starts(parts.topology.patchStarts);
    starts.append(parts.topology.faces.size());
    autoPtr<polyMesh> mesh
    (
        meshWithoutPatches
        (
            io, std::move(parts.points), std::move(parts.topology)
        )
    );
    PtrList<polyPatch> patches
    (
        makePatches(parts.patches, starts, mesh->boundaryMesh())
    );
    mesh->addPatches(patches, true);
    addZones(parts, *mesh);

    return mesh;
}


label writePrismMesh
(
    const prismLayers& layers,
    farFieldMesh& far,
    const IOobject& io
)
{
    const prismMesh mesh(layers, far);
    mesh.write(io);

    return mesh.order.blocks().nFaces();
}


void writeMeshPiece(const meshPiece& piece, const IOobject& io)
{
    const prismMesh mesh(piece);
    const autoPtr<polyMesh> frame(mesh.write(io));
    const auto write = [&](const char* name, const labelUList& labels)
    {
        const IOobject object
        (
            name, frame->facesInstance(), polyMesh::meshSubDir, frame(),
            IOobject::NO_READ, IOobject::NO_WRITE, false
        );
        writeWhole(labelIOList(object, labelList(labels)));
    };
    labelList patches(identity(piece.patches.names.size()));
    patches.append(labelList(mesh.order.facesToProcesses().size(), -1));

    write("cellProcAddressing", piece.cellAddressing());
    write("faceProcAddressing", mesh.order.faceAddressing(piece));
    write("pointProcAddressing", mesh.order.pointAddressing(piece));
    write("boundaryProcAddressing", patches);
}

} // End namespace Foam

// ************************************************************************* //
