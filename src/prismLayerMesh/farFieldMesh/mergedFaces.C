/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mergedFaces.H"

#include <algorithm>
#include <numeric>

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

List<labelPair> mergedFaces::internalFaces
(
    const label nCells,
    labelList& starts
) const
{
    starts.setSize(nCells + 1, 0);
    forAll(old_.neighbour, f)
    {
        const labelPair cells(cellsOf(f));
        starts[cells.first()] += cells.first() != cells.second();
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    List<labelPair> faces(starts[nCells]);
    for (label f = old_.neighbour.size(); f--;)
    {
        const labelPair cells(cellsOf(f));
        if (cells.first() != cells.second())
        {
            faces[--starts[cells.first()]] = labelPair(cells.second(), f);
        }
    }

    #pragma omp parallel for schedule(static)
    for (label c = 0; c < nCells; ++c)
    {
        std::sort(faces.begin() + starts[c], faces.begin() + starts[c + 1]);
    }

    return faces;
}


void mergedFaces::addInternalFaces(const label nCells, polyMeshTopology& t)
{
    labelList starts;
    const List<labelPair> faces(internalFaces(nCells, starts));
    t.reserve(old_.faces.size(), faces.size());
    t.faces.setSize(faces.size());
    t.owner.setSize(faces.size());
    t.neighbour.setSize(faces.size());

    #pragma omp parallel for schedule(static)
    for (label c = 0; c < nCells; ++c)
    {
        for (label k = starts[c]; k < starts[c + 1]; ++k)
        {
            const label f = faces[k].second();
            faces_[f] = k;
            flipped_[f] = cells_[old_.owner[f]] != c;
            t.owner[k] = c;
            t.neighbour[k] = faces[k].first();
            t.faces[k] = old_.faces[f];
            if (flipped_[f])
            {
                t.faces[k].flip();
            }
        }
    }
}


void mergedFaces::addPatches(polyMeshTopology& t)
{
    forAll(old_.patchStarts, patchi)
    {
        t.startPatch();
        const label start = old_.patchStarts[patchi];
        for (label k = 0; k < old_.patchSizes[patchi]; ++k)
        {
            const label f = start + k;
            if (!mesh_.gone().test(f))
            {
                const auto polygon = mesh_.polygons().cfind(f);
                faces_[f] = t.faces.size();
                t.append
                (
                    face(polygon.good() ? *polygon : old_.faces[f]),
                    cells_[old_.owner[f]]
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

mergedFaces::mergedFaces
(
    const mergingMesh& mesh,
    const labelList& newCells,
    const label nNewCells,
    polyMeshTopology& t
)
:
    mesh_(mesh),
    old_(mesh.far().topology),
    cells_(newCells),
    faces_(old_.faces.size(), -1),
    flipped_(old_.faces.size(), false)
{
    addInternalFaces(nNewCells, t);
    addPatches(t);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void mergedFaces::update(cellZoneParts& zone) const
{
    bitSet cells(cells_.size());
    for (const label c : zone.cells)
    {
        cells.set(cells_[c]);
    }
    zone.cells = cells.sortedToc();
}


void mergedFaces::update(faceZoneParts& zone) const
{
    DynamicList<label> faces;
    DynamicList<bool> flips;
    forAll(zone.faces, k)
    {
        const label f = zone.faces[k];
        if (faces_[f] >= 0)
        {
            faces.append(faces_[f]);
            flips.append(zone.flips[k] != flipped_[f]);
        }
    }
    zone.faces = faces;
    zone.flips = flips;
}

} // End namespace Foam

// ************************************************************************* //
