/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearGiven.H"
#include "triPointRef.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Largest angle [degrees] between a triangle and the given surface
static constexpr scalar normalAngle = 45;

//- The surface is not further away than this share of the longest edge of a
//  triangle
static constexpr scalar farFromTriangle = 0.1;


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar reachOf(const FixedList<point, 3>& x)
{
    return max(mag(x[1] - x[0]), max(mag(x[2] - x[1]), mag(x[0] - x[2])));
}


bool isNear
(
    const givenSurface& given,
    const FixedList<point, 3>& triangle,
    label& nearest
)
{
    static const scalar minCos = Foam::cos(degToRad(normalAngle));
    const triPointRef t(triangle[0], triangle[1], triangle[2]);
    const point centre(t.centre());
    const vector area(t.areaNormal());
    const scalar reach = reachOf(triangle);
    point y;
    nearest = given.findFace(nearest, centre, reach, y);

    return
        mag(centre - y) <= min
        (
            given.deviation(nearest), farFromTriangle*reach
        )
     && (area & given.normals()[nearest]) > minCos*mag(area);
}


bool isNear
(
    const givenSurface& given,
    const point& a,
    const point& b,
    const label start
)
{
    const point x(0.5*(a + b));
    point y;
    const scalar reach = mag(a - b);
    const label near = given.findFace(start, x, reach, y);

    return mag(x - y) <= min(given.deviation(near), farFromTriangle*reach);
}

} // End namespace Foam

// ************************************************************************* //
