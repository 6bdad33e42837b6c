/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellGeometry.H"
#include "prismQuality.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether the centre of a cell is on the inner side of all its faces. Those
//  are given with area vectors outwards; which is as in
//  primitiveMesh::checkFacePyramids.
static bool hasPositivePyramids(const UList<faceGeometry>& faces)
{
    const cellGeometry cell(faces);
    if (cell.volume3 <= VSMALL)
    {
        return false;
    }

    for (const faceGeometry& f : faces)
    {
        // Faces without area have no pyramid
        if (f.pyramid3(cell.centre) < -SMALL*cell.volume3)
        {
            return false;
        }
    }

    return true;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool hasPositivePyramids(const prismLayers& layers, const label facei)
{
    const face& f = layers.faces[facei];
    const label n = f.size();

    // Lower face, upper face, sides
    List<faceGeometry> faces(n + 2);

    for (label i = 0; i <= layers.nLayers; ++i)
    {
        faces[0] = faces[1];
        faces[0].area *= -1;
        faces[1] = faceGeometry(levelPoints{layers, f, i});

        for (label k = 0; i > 0 && k < n; ++k)
        {
            faces[2 + k] = faceGeometry
            (
                sidePoints{layers, f[k], f[f.fcIndex(k)], i}
            );
        }

        if (i > 0 && !hasPositivePyramids(faces))
        {
            return false;
        }
    }

    return true;
}

} // End namespace Foam

// ************************************************************************* //
