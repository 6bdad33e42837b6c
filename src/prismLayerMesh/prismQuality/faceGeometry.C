/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceGeometry.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

faceGeometry::faceGeometry(const UList<point>& points)
{
    const label n = points.size();

    if (n == 3)
    {
        centre = (1.0/3.0)*(points[0] + points[1] + points[2]);
        area = 0.5*((points[1] - points[0])^(points[2] - points[0]));
        return;
    }

    point middle(Zero);
    for (const point& p : points)
    {
        middle += p;
    }
    middle /= n;

    vector sumN(Zero);
    vector sumAc(Zero);
    scalar sumA = 0;

    for (label k = 0; k < n; ++k)
    {
        const point& p = points[k];
        const point& q = points[k + 1 < n ? k + 1 : 0];

        const vector normal((q - p)^(middle - p));
        const scalar a = mag(normal);

        sumN += normal;
        sumA += a;
        sumAc += a*(p + q + middle);
    }

    area = 0.5*sumN;
    centre = sumA > VSMALL ? sumAc/(3*sumA) : middle;
}

} // End namespace Foam

// ************************************************************************* //
