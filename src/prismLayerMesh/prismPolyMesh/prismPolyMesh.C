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
const word farFieldName("farField");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void addPatches
(
    const polyMeshTopology& topology,
    const layerPatches& all,
    polyMesh& mesh
)
{
    PtrList<polyPatch> patches(all.names.size());

    forAll(patches, patchi)
    {
        patches.set
        (
            patchi,
            polyPatch::New
            (
                all.types[patchi],
                all.names[patchi],
                topology.patchSizes[patchi],
                topology.patchStarts[patchi],
                patchi,
                mesh.boundaryMesh()
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


static layerPatches patchesOfWall(const prismLayers& layers)
{
    layerPatches wall;
    wall.names = prismPatchNames(layers.patchNames);
    wall.types = wordList(wall.names.size(), word("wall"));
    SubList<word>(wall.types, layers.patchTypes.size()) = layers.patchTypes;

    return wall;
}


//- The points of the mesh, which leaves nothing of layers and far field
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
    far = farFieldMesh();

    return points;
}


//- The first cells are those of the layers
static void addCellZones(const label nLayerCells, polyMesh& mesh)
{
    const label nFar = mesh.nCells() - nLayerCells;

    mesh.addZones
    (
        List<pointZone*>(),
        List<faceZone*>(),
        List<cellZone*>
        ({
            new cellZone
            (
                boundaryLayerName, identity(nLayerCells), 0, mesh.cellZones()
            ),
            new cellZone
            (
                farFieldName, identity(nFar, nLayerCells), 1, mesh.cellZones()
            )
        })
    );
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


layerPatches patchesOfLayers(const prismLayers& layers, const label nOpen)
{
    layerPatches patches(patchesOfWall(layers));
    const auto add = [&](const word& name, const word& type)
    {
        patches.names.append(name);
        patches.types.append(type);
    };

    add(layerOuterName, "patch");
    const wordList sides(sidePatchNames(layers.border));
    for (const word& name : sides)
    {
        add(name, typeOfSide(layers.border, name));
    }
    if (nOpen > sides.size())
    {
        add(layerSidesName, "patch");
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
    layerPatches patches(patchesOfWall(layers));

    if (hasFarField)
    {
        topology = joinFarField
        (
            layers, topology,
            layers.points.size() - layers.extraColumnPoints.size(), far
        );
        patches.names.append(far.patchNames);
        patches.types.append(far.patchTypes);
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
        addCellZones(nLayerCells, mesh());
    }

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
