/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coneVolume.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- More digits than those of the coordinates: of a thin cell little is left
//  when the products are summed
struct longVector
{
    long double x, y, z;

    longVector(const point& p, const point& origin)
    :
        x(p.x()),
        y(p.y()),
        z(p.z())
    {
        x -= origin.x();
        y -= origin.y();
        z -= origin.z();
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

long double Foam::coneVolume
(
    const face& f,
    const pointField& points,
    const point& origin
)
{
    const longVector a(f.centre(points), origin);

    long double sum = 0;

    forAll(f, i)
    {
        const longVector b(points[f[i]], origin);
        const longVector c(points[f.nextLabel(i)], origin);

        sum +=
            a.x*(b.y*c.z - b.z*c.y)
          + a.y*(b.z*c.x - b.x*c.z)
          + a.z*(b.x*c.y - b.y*c.x);
    }

    return sum;
}


long double Foam::coneVolume
(
    const UList<face>& faces,
    const pointField& points,
    const point& origin
)
{
    long double sum = 0;

    for (const face& f : faces)
    {
        sum += coneVolume(f, points, origin);
    }

    return sum;
}


// ************************************************************************* //
