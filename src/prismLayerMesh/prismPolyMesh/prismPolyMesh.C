/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh.H"
#include "findFaceNeighbours.H"
#include "meshFiles.H"
#include "meshOrder.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const word boundaryLayerName("boundaryLayer");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- starts: the first face of each patch, then the number of all faces
static void addPatches
(
    const labelList& starts,
    const meshPatches& all,
    const bool isWhole,
    polyMesh& mesh
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
            patchi,
            polyPatch::New
            (
                all.names[patchi], patch, patchi, mesh.boundaryMesh()
            )
        );
    }

    mesh.addPatches(patches, isWhole);
}


//- The cells of a zone of the far field in the mesh, where they follow those of
//  the layers
static labelList cellsOf
(
    const prismLayers& layers,
    const cellZoneParts& zone
)
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


static void addZones
(
    const prismLayers& layers,
    const farFieldMesh& far,
    const meshOrder& order,
    polyMesh& mesh
)
{
    List<cellZone*> cells
    ({
        new cellZone
        (
            boundaryLayerName, identity(layers.faces.size()*layers.nLayers), 0,
            mesh.cellZones()
        )
    });
    List<faceZone*> faces;

    for (const cellZoneParts& zone : far.cellZones)
    {
        cells.append
        (
            new cellZone
            (
                zone.name, cellsOf(layers, zone), cells.size(),
                mesh.cellZones()
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


//- The points of a mesh
static pointField pointsOf(const meshBlocks& mesh)
{
    DynamicList<point> points(mesh.nPoints);
    for (label i = 0; i < mesh.nPointBlocks; ++i)
    {
        points.append(mesh.points(i));
    }

    return pointField(std::move(points));
}


namespace
{

//- The mesh of layers and far field before it is a polyMesh, or files
struct prismMesh
{
    const prismLayers& layers;
    farFieldMesh& far;
    labelListList faceNeighbours;
    List<DynamicList<labelPair>> open;
    meshPatches patches;
    meshOrder order;

    prismMesh(const prismLayers& l, farFieldMesh& f)
    :
        layers(l),
        far(f),
        faceNeighbours(findFaceNeighbours(l)),
        open(openEdges(l, faceNeighbours)),
        patches(patchesOfMesh(l, open.size(), f)),
        order(l, f, std::move(faceNeighbours), open)
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
        IOobject unread(io);
        unread.readOpt() = IOobject::NO_READ;
        const bool isWhole = points.size();
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
        addPatches(order.patchStarts(), patches, isWhole, mesh());
        if (!far.empty())
        {
            addZones(layers, far, order, mesh());
        }

        return mesh;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
        io, pointsOf(mesh.order.blocks()), makeTopology(mesh.order)
    );
}


label writePrismMesh
(
    const prismLayers& layers,
    farFieldMesh& far,
    const IOobject& io
)
{
    const prismMesh mesh(layers, far);
    const label nFaces = mesh.order.blocks().nFaces();

    // Zones of faces look whether they have labels of faces
    polyMeshTopology nothing;
    nothing.faces.setSize(far.faceZones.size() ? nFaces : 0);
    nothing.owner.setSize(nothing.faces.size(), 0);
    const autoPtr<polyMesh> frame
    (
        mesh.make(io, pointField(), std::move(nothing))
    );
    writeMeshFiles(frame(), mesh.order.blocks());

    return nFaces;
}

} // End namespace Foam

// ************************************************************************* //
