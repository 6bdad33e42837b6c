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
    const wordList& names,
    const wordList& types,
    polyMesh& mesh
)
{
    PtrList<polyPatch> patches(names.size());

    forAll(patches, patchi)
    {
        patches.set
        (
            patchi,
            polyPatch::New
            (
                types[patchi],
                names[patchi],
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
    wordList names(prismPatchNames(layers.patchNames));
    wordList types(names.size(), word("wall"));
    SubList<word>(types, layers.patchTypes.size()) = layers.patchTypes;

    if (hasFarField)
    {
        topology = joinFarField
        (
            layers, topology,
            layers.points.size() - layers.extraColumnPoints.size(), far
        );
        names.append(far.patchNames);
        types.append(far.patchTypes);
    }

    else
    {
        names.append(layerOuterName);
        types.append("patch");

        for (const word& name : sidePatchNames(layers.border))
        {
            names.append(name);
            types.append(typeOfSide(layers.border, name));
        }
    }

    names.append(layerSidesName);
    names.setSize(topology.patchStarts.size());
    types.setSize(names.size(), word("patch"));

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
    addPatches(topology, names, types, mesh());

    if (hasFarField)
    {
        addCellZones(nLayerCells, mesh());
    }

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
