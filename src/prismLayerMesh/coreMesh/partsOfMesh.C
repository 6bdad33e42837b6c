/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partsOfMesh.H"
#include "labelPair.H"
#include "ListOps.H"
#include "polyMesh.H"
#include "regionSplit.H"
#include "searchTree.H"
#include "StringStream.H"
#include "treeDataCell.H"

namespace Foam
{

namespace
{

//- The cells of one region
class regionCells
{
    boundBox box_;
    autoPtr<indexedOctree<treeDataCell>> tree_;

public:

    regionCells(const polyMesh& mesh, const labelList& cells)
    :
        box_(boundBox::invertedBox)
    {
        for (const label celli : cells)
        {
            box_.add(mesh.points(), mesh.cellPoints(celli));
        }
        const treeDataCell items(true, mesh, cells, polyMesh::FACE_PLANES);
        tree_ = makeSearchTree(items, box_, 1e-4, 8);
    }

    //- The cell at a place, or -1
    label at(const point& x) const
    {
        const label i = box_.contains(x) ? tree_->findInside(x) : -1;

        return i < 0 ? -1 : tree_->shapes().cellLabels()[i];
    }
};

} // End anonymous namespace


//- Returns a cell whose centre is in a cell of another region of the mesh, and
//  that other cell; labels -1 if there is none. Cells of one region do not
//  overlap if all are positive.
static labelPair overlappingCells(const polyMesh& mesh)
{
    const regionSplit regions(mesh);
    const labelListList cellsOf(invertOneToMany(regions.nRegions(), regions));

    for (label i = 0; regions.nRegions() > 1 && i < cellsOf.size(); ++i)
    {
        const regionCells region(mesh, cellsOf[i]);
        forAll(mesh.cellCentres(), celli)
        {
            const label other = regions[celli] == i
              ? -1 : region.at(mesh.cellCentres()[celli]);
            if (other >= 0)
            {
                return labelPair(celli, other);
            }
        }
    }

    return labelPair(-1, -1);
}


// * * * * * * * * * * * * * * *  Parts Of Mesh  * * * * * * * * * * * * * * //

static void checkPatches(const polyMesh& mesh)
{
    const wordList refused({"empty", "wedge", "processor", "processorCyclic"});

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (refused.found(patch.type()))
        {
            FatalErrorInFunction
                << "The patch " << patch.name() << " of the mesh around the"
                << " layers is of type " << patch.type() << nl
                << "Layers need a mesh in three dimensions, of one process:"
                << " reconstructParMesh joins the pieces of several"
                << exit(FatalError);
        }
    }
}


//- Another run may have put layers there, and the tetrahedra need a name
static void checkZones(const polyMesh& mesh)
{
    const wordList names(mesh.cellZones().names());

    if (names.found("boundaryLayer"))
    {
        FatalErrorInFunction
            << "The mesh around the layers has layers already: its cellZone"
            << " boundaryLayer" << nl
            << "Make it anew, or keep it as a region: farField.region"
            << exit(FatalError);
    }
    if (names.found("farField"))
    {
        FatalErrorInFunction
            << "The mesh around the layers has a cellZone farField. The"
            << " tetrahedra need this name" << nl
            << "Rename the zone" << exit(FatalError);
    }
}


static void checkCells(const polyMesh& mesh)
{
    const scalarField& volumes = mesh.cellVolumes();
    const label worst = findMin(volumes);

    if (mesh.nCells() == 0 || volumes[worst] <= 0)
    {
        FatalErrorInFunction
            << "The mesh around the layers has "
            << (mesh.nCells() ? "a cell that is not positive" : "no cells");
        if (mesh.nCells())
        {
            FatalError
                << ": cell " << worst << " at " << mesh.cellCentres()[worst]
                << ", volume " << volumes[worst] << nl
                << "checkMesh names all such cells";
        }
        FatalError << exit(FatalError);
    }
}


static void checkOverlap(const polyMesh& mesh)
{
    const labelPair cells(overlappingCells(mesh));

    if (cells.first() >= 0)
    {
        FatalErrorInFunction
            << "Cells of the mesh around the layers overlap: cell "
            << cells.first() << " at " << mesh.cellCentres()[cells.first()]
            << " is in cell " << cells.second() << " of another region" << nl
            << "Remove the cells of one region that are inside of the other"
            << exit(FatalError);
    }
}


static void addPatches(const polyMesh& mesh, polyMeshParts& parts)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        OStringStream text;
        patch.write(text);
        dictionary entries(IStringStream(text.str())());
        entries.remove("nFaces");
        entries.remove("startFace");

        parts.patches.names.append(patch.name());
        parts.patches.entries.append(entries);
        parts.topology.patchStarts.append(patch.start());
        parts.topology.patchSizes.append(patch.size());
    }
}


polyMeshParts partsOf(const polyMesh& mesh)
{
    checkPatches(mesh);
    checkZones(mesh);
    checkCells(mesh);
    checkOverlap(mesh);

    polyMeshParts parts;
    parts.points = mesh.points();
    parts.nCells = mesh.nCells();
    parts.topology.faces = mesh.faces();
    parts.topology.owner = mesh.faceOwner();
    parts.topology.neighbour = mesh.faceNeighbour();
    addPatches(mesh, parts);

    for (const cellZone& zone : mesh.cellZones())
    {
        parts.cellZones.append(cellZoneParts(zone.name(), zone));
    }
    for (const faceZone& zone : mesh.faceZones())
    {
        parts.faceZones.append({zone.name(), zone, zone.flipMap()});
    }

    return parts;
}

} // End namespace Foam

// ************************************************************************* //
