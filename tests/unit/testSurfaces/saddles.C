/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "saddles.H"
#include "wallVisibility.H"
#include "Random.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace testSurfaces
{

//- Whether the cubes whose bits are set hang together by their sides
static bool connected(const unsigned cubes)
{
    unsigned seen = cubes & -cubes;

    for (label round = 0; round < 8; ++round)
    {
        for (label i = 0; i < 8; ++i)
        {
            for (const unsigned side : {1u, 2u, 4u})
            {
                if (seen & (1u << i))
                {
                    seen |= cubes & (1u << (i ^ side));
                }
            }
        }
    }

    return seen == cubes;
}


//- The point of the wall that is there
static label pointAt(const wallSurface& wall, const point& x)
{
    forAll(wall.points, p)
    {
        if (mag(wall.points[p] - x) < 1e-9)
        {
            return p;
        }
    }

    return -1;
}

} // End namespace testSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::List<Foam::testSurfaces::saddle> Foam::testSurfaces::screws()
{
    DynamicList<saddle> screws;

    for (unsigned filled = 1; filled < 255; ++filled)
    {
        if (!connected(filled) || !connected(255 & ~filled))
        {
            continue;
        }

        const wallSurface wall(cubesAbout(Zero, filled));
        const label p = pointAt(wall, Zero);

        if (makeWallVisibility(wall, makeWallAddressing(wall)).cones[p].empty())
        {
            screws.append(saddle{std::to_string(filled), wall, p});
        }
    }

    return List<saddle>(std::move(screws));
}


Foam::List<Foam::testSurfaces::saddle> Foam::testSurfaces::saddles()
{
    DynamicList<saddle> all(screws());

    for (const scalar thickness : {0.1, 1e-3})
    {
        const wallSurface wall(bladeOnEdge(thickness));

        all.append(saddle{"left of blade", wall, pointAt(wall, Zero)});
        all.append
        (
            saddle
            {
                "right of blade", wall, pointAt(wall, point(thickness, 0, 0))
            }
        );
    }

    Random random(3);

    for (const label n : {10, 12, 16, 24})
    {
        for (label i = 0; i < 10; ++i)
        {
            const vectorField seam(tennisBallSeam(n, 0.4, 0.6, random));

            all.append(saddle{"fan of " + std::to_string(n), fan(seam), 0});
        }
    }

    return List<saddle>(std::move(all));
}


// ************************************************************************* //
