/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polyMeshParts.H"
#include "cell.H"
#include "Map.H"
#include "sidePair.H"
#include "UIndirectList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void polyMeshTopology::setPatches(const UList<labelList>& patchFaces)
{
    DynamicList<label> order(identity(neighbour.size()));
    patchStarts.clear();
    patchSizes.clear();
    for (const labelList& ofPatch : patchFaces)
    {
        patchStarts.append(order.size());
        patchSizes.append(ofPatch.size());
        order.append(ofPatch);
    }
    faces = faceList(UIndirectList<face>(faces, order));
    owner = labelList(UIndirectList<label>(owner, order));
}


void polyMeshTopology::addEmptyPatch(const label patchi)
{
    patchStarts.append(faces.size());
    patchSizes.append(0);
    for (label i = patchSizes.size() - 1; i > patchi; --i)
    {
        patchStarts[i] = patchStarts[i - 1];
        std::swap(patchSizes[i], patchSizes[i - 1]);
    }
}


void meshPatches::append(const word& name, const word& type)
{
    names.append(name);

    dictionary patch;
    patch.add("type", type);
    entries.append(patch);
}


wordList meshPatches::types() const
{
    wordList all(entries.size());
    forAll(all, patchi)
    {
        all[patchi] = entries[patchi].get<word>("type");
    }

    return all;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void setCyclic(const UList<sidePatch>& sides, meshPatches& patches)
{
    for (const sidePair& pair : pairsOf(sides))
    {
        for (const label side : {pair.first, pair.second})
        {
            const label patchi = patches.names.find(sides[side].name);
            if (patchi >= 0)
            {
                patches.entries[patchi] = pair.entries(sides, side);
            }
        }
    }
}


void setCentresAndVolumes
(
    const polyMeshParts& mesh,
    const labelUList& cells,
    pointField& centres,
    scalarField& volumes
)
{
    // Faces of the cells that are asked for
    boolList wanted(mesh.nCells, false);
    UIndirectList<bool>(wanted, cells) = true;
    Map<DynamicList<label>> facesOf(2*cells.size());

    forAll(mesh.topology.faces, facei)
    {
        const label own = mesh.topology.owner[facei];
        const label nei = mesh.topology.beyond(facei);
        if (wanted[own])
        {
            facesOf(own).append(facei);
        }
        if (nei >= 0 && wanted[nei])
        {
            facesOf(nei).append(facei);
        }
    }

    centres.setSize(cells.size());
    volumes.setSize(cells.size());
    forAll(cells, i)
    {
        const cell c(facesOf[cells[i]]);
        centres[i] = c.centre(mesh.points, mesh.topology.faces);
        volumes[i] = c.mag(mesh.points, mesh.topology.faces);
    }
}

} // End namespace Foam

// ************************************************************************* //
