/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh.H"
#include "HashSet.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const word layerOuterName("layerOuter");
const word layerSidesName("layerSides");
const word boundaryLayerName("boundaryLayer");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void addPatches
(
    const polyMeshTopology& topology,
    const meshPatches& all,
    polyMesh& mesh
)
{
    PtrList<polyPatch> patches(all.names.size());

    forAll(patches, patchi)
    {
        dictionary patch(all.entries[patchi]);
        patch.set("nFaces", topology.patchSizes[patchi]);
        patch.set("startFace", topology.patchStarts[patchi]);
        patches.set
        (
            patchi,
            polyPatch::New
            (
                all.names[patchi], patch, patchi, mesh.boundaryMesh()
            )
        );
    }

    mesh.addPatches(patches);
}


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


static meshPatches patchesOfWall(const prismLayers& layers)
{
    const wordList names(prismPatchNames(layers.patchNames));
    meshPatches wall;
    forAll(names, patchi)
    {
        wall.append
        (
            names[patchi],
            patchi < layers.patchTypes.size()
          ? layers.patchTypes[patchi] : word("wall")
        );
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
                << "The mesh around the layers has a patch " << name
                << ", as the wall has, of which " << size << " faces stay"
                << nl << "Name one of them otherwise" << exit(FatalError);
        }
    }

    far.keepPatches(kept);
}


//- The points of the mesh, which leaves nothing of the layers' and the far
//  field's
static pointField takePoints(prismLayers& layers, farFieldMesh& far)
{
    const label n = layers.nColumns();
    pointField points
    (
        layers.extraColumnPoints.size()
      ? layers.meshPoints() : pointField(std::move(layers.points))
    );

    if (!far.empty())
    {
        points.append(SubList<point>(far.points, far.points.size() - n, n));
    }

    layers = prismLayers();
    far.points.clear();

    return points;
}


//- The first cells are those of the layers
static void addZones
(
    const label nLayerCells,
    const farFieldMesh& far,
    polyMesh& mesh
)
{
    List<cellZone*> cells
    ({
        new cellZone
        (
            boundaryLayerName, identity(nLayerCells), 0, mesh.cellZones()
        )
    });
    List<faceZone*> faces;

    for (const cellZoneParts& zone : far.cellZones)
    {
        cells.append
        (
            new cellZone(zone.name, zone.cells, cells.size(), mesh.cellZones())
        );
    }
    for (const faceZoneParts& zone : far.faceZones)
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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


meshPatches patchesOfLayers(const prismLayers& layers, const label nOpen)
{
    meshPatches patches(patchesOfWall(layers));

    patches.append(layerOuterName, "patch");
    const wordList sides(sidePatchNames(layers.border));
    for (const word& name : sides)
    {
        patches.append(name, typeOfSide(layers.border, name));
    }
    if (nOpen > sides.size())
    {
        patches.append(layerSidesName, "patch");
    }

    return patches;
}


autoPtr<polyMesh> makePrismPolyMesh
(
    prismLayers& layers,
    farFieldMesh& far,
    const IOobject& io
)
{
    const bool hasFarField = !far.empty();
    const label nLayerCells = layers.faces.size()*layers.nLayers;
    polyMeshTopology topology(makePrismTopology(layers));
    meshPatches patches(patchesOfWall(layers));

    if (hasFarField)
    {
        dropPatchesOfWall(patches.names, far);
        topology = joinFarField
        (
            layers, topology,
            layers.points.size() - layers.extraColumnPoints.size(), far
        );
        far.topology = polyMeshTopology();
        patches.names.append(far.patches.names);
        patches.entries.append(far.patches.entries);
    }
    else
    {
        const label nWall = layers.patchNames.size();
        const label nOpen = topology.patchSizes.size() - nWall - 1;
        patches = patchesOfLayers(layers, nOpen);
    }

    IOobject unread(io);
    unread.readOpt() = IOobject::NO_READ;
    pointField points(takePoints(layers, far));

    autoPtr<polyMesh> mesh
    (
        new polyMesh
        (
            unread,
            std::move(points),
            faceList(std::move(topology.faces)),
            labelList(std::move(topology.owner)),
            labelList(std::move(topology.neighbour))
        )
    );
    addPatches(topology, patches, mesh());

    if (hasFarField)
    {
        addZones(nLayerCells, far, mesh());
    }

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
