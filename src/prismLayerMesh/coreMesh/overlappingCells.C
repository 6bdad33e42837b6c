/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "overlappingCells.H"
#include "ListOps.H"
#include "polyMesh.H"
#include "regionSplit.H"
#include "searchTree.H"
#include "treeDataCell.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelPair overlappingCells(const polyMesh& mesh)
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

} // End namespace Foam

// ************************************************************************* //
