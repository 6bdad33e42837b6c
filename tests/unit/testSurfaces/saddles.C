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


Foam::testSurfaces::saddle Foam::testSurfaces::woundFan()
{
    // The only point without a division in 24,000 random bodies that random
    // planes cut
    const vectorField directions
    ({
        vector(-0.52875, -0.50132, 0.68491),
        vector(-0.55352, 0.41622, -0.72137),
        vector(-0.34977, 0.86071, 0.36991),
        vector(-0.10416, 0.83397, 0.54189),
        vector(0.18360, 0.98031, 0.07263),
        vector(0.44906, 0.52661, -0.72183),
        vector(0.49475, 0.49873, -0.71168),
        vector(-0.89412, -0.12454, -0.43016),
        vector(0.99727, -0.02120, 0.07079),
        vector(0.97739, 0.18432, -0.10356),
        vector(-0.15083, -0.55025, 0.82126)
    });

    return saddle{"wound fan", fan(directions), 0};
}


// ************************************************************************* //
