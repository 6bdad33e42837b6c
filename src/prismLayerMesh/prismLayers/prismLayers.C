/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayers.H"
#include "bitSet.H"
#include "error.H"
#include "layerFront.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList prismLayers::columnsOf(const labelUList& stacks) const
{
    bitSet columns(nColumns());
    for (const label facei : stacks)
    {
        columns.set(faces[facei]);
    }

    return columns.toc();
}


label prismLayers::root(const label c) const
{
    const label further = c - nWallPoints();

    return further < 0 ? c : extraColumnPoints[further];
}


label prismLayers::pointLabel(const label c, const label i) const
{
    const label further = extraColumnPoints.size() ? c - nWallPoints() : -1;

    return
        further < 0 ? index(c, i)
      : i ? index(c, i) - (further + 1)
      : index(extraColumnPoints[further], 0);
}


pointField prismLayers::meshPoints() const
{
    pointField result(points);
    for (label c = nWallPoints(); c < nColumns(); ++c)
    {
        for (label i = 1; i <= nLayers; ++i)
        {
            result[pointLabel(c, i)] = (*this)(c, i);
        }
    }
    result.setSize(points.size() - extraColumnPoints.size());

    return result;
}


pointField prismLayers::pointsOf(const label i) const
{
    pointField level(nColumns());
    forAll(level, c)
    {
        level[c] = (*this)(c, i);
    }

    return level;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismLayers layersWithoutPoints(const layerFront& front, const label nLayers)
{
    const wallSurface& surface = front.surface;
    prismLayers layers;
    layers.nLayers = nLayers;
    layers.faces = surface.faces;
    layers.patchIDs = SubList<label>(surface.patchIDs, front.nWallFaces);
    layers.patchNames = surface.patchNames;
    layers.patchTypes = surface.patchTypes;
    layers.border = surface.border;
    layers.extraColumnPoints = front.extraColumnPoints();

    return layers;
}


prismLayers wallWithoutLayers(const wallSurface& wall)
{
    prismLayers layers;
    layers.points = wall.points;
    layers.faces = wall.faces;
    layers.patchIDs = wall.patchIDs;
    layers.patchNames = wall.patchNames;
    layers.patchTypes = wall.patchTypes;
    layers.border = wall.border;

    return layers;
}


void requireCountable(const std::int64_t nWallEdges, const std::int64_t nLayers)
{
    // Faces of the wall have two for each edge, sides have four
    const std::int64_t nCorners = (2*(nLayers + 1) + 4*nLayers)*nWallEdges;

    if (nCorners > labelMax)
    {
        FatalErrorInFunction
            << "The faces of " << label(nLayers) << " layers would have "
            << std::to_string(nCorners).c_str() << " corners. Labels of "
            << label(8*sizeof(label)) << " bits count only " << labelMax
            << ". Ask for fewer layers, use fewer faces, or an OpenFOAM with"
            << " WM_LABEL_SIZE=64" << exit(FatalError);
    }
}

} // End namespace Foam

// ************************************************************************* //
