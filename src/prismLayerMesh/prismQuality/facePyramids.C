/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellGeometry.H"
#include "prismQuality.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether the centre of a cell is on the inner side of all its faces. Those
//  are given with area vectors outwards; which is as in
//  primitiveMesh::checkFacePyramids.
static bool hasPositivePyramids(const UList<faceGeometry>& faces)
{
    const cellGeometry cell(faces);

    // Faces without area have no pyramid
    return cell.volume3 > VSMALL && allOf(faces, [&](const faceGeometry& f)
    {
        return f.pyramid3(cell.centre) >= -SMALL*cell.volume3;
    });
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool hasPositivePyramids(const prismLayers& layers, const label facei)
{
    return visitCells
    (
        layers, layers.faces[facei],
        [](label, const UList<faceGeometry>& faces)
        {
            return hasPositivePyramids(faces);
        }
    );
}

} // End namespace Foam

// ************************************************************************* //
