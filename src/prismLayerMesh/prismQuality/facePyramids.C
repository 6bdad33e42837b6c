/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceGeometry.H"
#include "prismQuality.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether the centre of a cell is on the inner side of all its faces. Those
//  are given with area vectors outwards; which is as in
//  primitiveMesh::makeCellCentresAndVols and checkFacePyramids.
static bool hasPositivePyramids(const UList<faceGeometry>& faces)
{
    point estimate(Zero);
    for (const faceGeometry& f : faces)
    {
        estimate += f.centre/scalar(faces.size());
    }

    vector sum(Zero);
    scalar volume3 = 0;
    for (const faceGeometry& f : faces)
    {
        const scalar v = f.pyramid3(estimate);
        volume3 += v;
        sum += v*(0.75*(f.centre - estimate));
    }

    if (volume3 <= VSMALL)
    {
        return false;
    }

    const point centre(estimate + sum/volume3);

    for (const faceGeometry& f : faces)
    {
        // Faces without area have no pyramid
        if (f.pyramid3(centre) < -SMALL*volume3)
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
    List<point> points(n);
    List<point> side(4);

    for (label i = 0; i <= layers.nLayers; ++i)
    {
        faces[0] = faces[1];
        faces[0].area *= -1;

        for (label k = 0; k < n; ++k)
        {
            points[k] = layers(f[k], i);
        }
        faces[1] = faceGeometry(points);

        for (label k = 0; i > 0 && k < n; ++k)
        {
            const label next = k + 1 < n ? k + 1 : 0;
            side[0] = layers(f[k], i - 1);
            side[1] = layers(f[next], i - 1);
            side[2] = points[next];
            side[3] = points[k];
            faces[2 + k] = faceGeometry(side);
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
