/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceValues.H"
#include "triSurfaceSearch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static barycentric2D coordinates
(
    const pointField& points,
    const labelledTri& triangle,
    const point& x
)
{
    // Scaled to a length of 1, because triangle takes small ones for degenerate
    const point& origin = points[triangle[0]];
    const vector a(points[triangle[1]] - origin);
    const vector b(points[triangle[2]] - origin);
    const scalar length = max(max(mag(a), mag(b)), VSMALL);

    return triPointRef(Zero, a/length, b/length)
       .pointToBarycentric((x - origin)/length);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar interpolate
(
    const surfaceValues& source,
    const pointField& points,
    scalarField& values
)
{
    const triSurface surface(toTriSurface(source.surface));
    const triSurfaceSearch search(surface);

    List<pointIndexHit> hits;
    search.findNearest(points, scalarField(points.size(), GREAT), hits);

    values.setSize(points.size());
    scalar farthest = 0;

    forAll(points, p)
    {
        const labelledTri& f = surface[hits[p].index()];
        const barycentric2D weights
        (
            coordinates(source.surface.points, f, hits[p].hitPoint())
        );

        values[p] = 0;
        for (direction i = 0; i < 3; ++i)
        {
            values[p] += weights[i]*source.values[f[i]];
        }

        farthest = max(farthest, mag(hits[p].hitPoint() - points[p]));
    }

    return farthest;
}

} // End namespace Foam

// ************************************************************************* //
