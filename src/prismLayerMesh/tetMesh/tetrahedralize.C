/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetrahedralize.H"
#include "quaternion.H"
#include "error.H"
#include "isolatedProcess.H"
#include "orientation.H"
#include "ranges.H"
#include "stageProgress.H"
#include "tetgenRun.H"
#include "triangleIndex.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Constants that were tuned
const struct
{
    //- How often TetGen is started, each time with other coordinates: where the
    //  first attempts fail, each later one succeeds in about 1 of 3 cases
    label maxAttempts = 12;

    //- CPU time of the first attempt [s], and the points for which it has one
    //  second more: twice the time of any success. The second attempt has half
    //  of it, later ones a quarter, but not less than the shortest time.
    label seconds = 3;
    label pointsPerSecond = 16000;
    label shortest = 2;

    //- CPU time of the first attempt for tetrahedra of given sizes [s], and the
    //  number of tetrahedra, if there may be so many, for which it has one
    //  second more
    label sizedSeconds = 10;
    label tetsPerSecond = 24000;

    //- Tetrahedra that there may be for each point that is added
    label tetsPerPoint = 4;

    //- Facets stay as they are: not split (Y), coplanar ones not merged (M), no
    //  tolerance (T) in place of the exact predicates. Points that are not used
    //  are not left out (J): that would change the labels of the others.
    const char* keepFacets = "pYMJQT1e-16";

    //- Radius over shortest edge at most 1.3, dihedral angles from 12 to 130
    //  degrees, if it can be had, by refinement and then by flips and smoothing
    const char* shapes = "q1.3/12o/130O2/7";
} tuned;

} // End anonymous namespace


//- Rotations that lay nothing along the axes or their diagonals: on exactly
//  coplanar and cospherical points TetGen fails now and then, and with other
//  coordinates rarely again
static tensor generalRotation(const label attempt)
{
    return quaternion
    (
        normalised(vector(0.37, 0.61, 0.29)), 1.13 + attempt
    ).R();
}


//- Whether all facets are faces of tetrahedra: now and then TetGen adds a point
//  on a facet
static bool keepsFacets(const tetDomain& domain, const tetMesh& mesh)
{
    const triangleIndex facets(makeTriangleIndex(domain.facets));
    boolList isFace(domain.facets.size(), false);

    for (const tetCell& tet : mesh.tets)
    {
        for (label i = 0; i < 4; ++i)
        {
            const triFace f(tet.face(i));

            // Facets are on points of the domain
            if (max(max(f[0], f[1]), f[2]) < domain.points.size())
            {
                const label facet = facets.lookup(f, -1);

                if (facet >= 0)
                {
                    isFace[facet] = true;
                }
            }
        }
    }

    return !isFace.found(false);
}


//- seconds: CPU time of the first attempt
static tetMesh attempts
(
    const tetDomain& domain,
    const tetgenOptions& options,
    const label seconds
)
{
    for (label attempt = 0; attempt < tuned.maxAttempts; ++attempt)
    {
        tellProgress("TetGen, points", domain.points.size());
        const tensor rotation(generalRotation(attempt));
        tetMesh mesh;

        const processEnd end = isolatedProcess
        (
            [&](pipeWriter& result)
            {
                runTetgen(domain, options, rotation, result);
            },
            [&](pipeReader& result)
            {
                mesh = readTetgen(domain, rotation, result);
            },
            max(seconds >> min(attempt, 2), tuned.shortest)
        );

        if
        (
            end == processEnd::complete && keepsFacets(domain, mesh)
         && allPositive(mesh.points, mesh.tets)
        )
        {
            return mesh;
        }
    }

    FatalErrorInFunction
        << "TetGen failed, or took too long, on "
        << domain.facets.size() << " facets and "
        << domain.points.size() << " points, " << tuned.maxAttempts << " times"
        << exit(FatalError);

    return tetMesh();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool allPositive(const UList<point>& x, const UList<tetCell>& tets)
{
    return allOf(tets, [&](const tetCell& tet)
    {
        return orientation(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) > 0;
    });
}


tetMesh tetrahedralize(const tetDomain& domain)
{
    return attempts
    (
        domain,
        tetgenOptions{tuned.keepFacets, nullptr},
        tuned.seconds + domain.points.size()/tuned.pointsPerSecond
    );
}


tetMesh tetrahedralize
(
    const tetDomain& domain,
    const std::function<scalar(const point&)>& size,
    const label maxTets
)
{
    return attempts
    (
        domain,
        tetgenOptions
        {
            std::string(tuned.keepFacets) + tuned.shapes + 'S'
          + std::to_string(maxTets/tuned.tetsPerPoint),
            size
        },
        tuned.sizedSeconds + maxTets/tuned.tetsPerSecond
    );
}

} // End namespace Foam

// ************************************************************************* //
