/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellGeometry.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

cellGeometry::cellGeometry(const UList<faceGeometry>& faces)
{
    point estimate(Zero);
    for (const faceGeometry& f : faces)
    {
        estimate += f.centre/scalar(faces.size());
    }

    vector sum(Zero);
    for (const faceGeometry& f : faces)
    {
        const scalar v = f.pyramid3(estimate);
        volume3 += v;
        sum += v*(0.75*(f.centre - estimate));
    }

    centre = volume3 > VSMALL ? estimate + sum/volume3 : estimate;
}

} // End namespace Foam

// ************************************************************************* //
