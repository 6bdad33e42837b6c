/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include <tetgen.h>

#include "tetrahedralize.H"
#include "quaternion.H"
#include "error.H"
#include "isolatedProcess.H"
#include "orientation.H"
#include "triangleIndex.H"

#include <string>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- How often TetGen tries, each time with other coordinates
static const label maxAttempts = 3;


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


//- tetgenio frees with delete[] what is given to it
static REAL* newCoordinates(const pointField& points, const tensor& rotation)
{
    REAL* xyz = new REAL[3*points.size() + 1];

    forAll(points, i)
    {
        const point x(rotation & points[i]);

        for (direction d = 0; d < 3; ++d)
        {
            xyz[3*i + d] = x[d];
        }
    }

    return xyz;
}


static void setFacets(tetgenio& io, const faceList& facets)
{
    io.numberoffacets = facets.size();
    io.facetlist = new tetgenio::facet[facets.size()];
    io.facetmarkerlist = new int[facets.size()];

    forAll(facets, i)
    {
        tetgenio::facet& f = io.facetlist[i];
        tetgenio::init(&f);
        f.numberofpolygons = 1;
        f.polygonlist = new tetgenio::polygon[1];

        tetgenio::polygon& polygon = f.polygonlist[0];
        polygon.numberofvertices = facets[i].size();
        polygon.vertexlist = new int[facets[i].size()];

        forAll(facets[i], j)
        {
            polygon.vertexlist[j] = facets[i][j];
        }

        io.facetmarkerlist[i] = 1;
    }
}


//- TetGen in its process: what makes tetrahedra of the wanted sizes
struct tetSizing
{
    std::function<scalar(const point&)> size;
    tensor rotation;

    //- TetGen's question has no place for more than coordinates
    static tetSizing current;

    static bool isLarge
    (
        REAL* a, REAL* b, REAL* c, REAL* d, REAL*, REAL
    );
};

tetSizing tetSizing::current;


//- Edges over the wanted size, at most
static const scalar maxLength = 1.6;

bool tetSizing::isLarge(REAL* a, REAL* b, REAL* c, REAL* d, REAL*, REAL)
{
    const point x[4] =
    {
        point(a[0], a[1], a[2]), point(b[0], b[1], b[2]),
        point(c[0], c[1], c[2]), point(d[0], d[1], d[2])
    };

    scalar longest = 0;
    for (label i = 0; i < 4; ++i)
    {
        for (label j = i + 1; j < 4; ++j)
        {
            longest = max(longest, magSqr(x[i] - x[j]));
        }
    }

    const point centre(0.25*(x[0] + x[1] + x[2] + x[3]));

    return
        longest > sqr(maxLength*current.size(centre & current.rotation));
}


//- How TetGen runs
struct tetRun
{
    std::string switches;
    std::function<scalar(const point&)> size;

    //- At the first attempt
    label seconds;
};


static void run
(
    const tetDomain& domain,
    const tetRun& how,
    const tensor& rotation,
    std::FILE* result
)
{
    tetgenio in, out;

    in.numberofpoints = domain.points.size();
    in.pointlist = newCoordinates(domain.points, rotation);
    in.numberofholes = domain.holes.size();
    in.holelist = newCoordinates(domain.holes, rotation);
    setFacets(in, domain.facets);

    if (how.size)
    {
        tetSizing::current = tetSizing{how.size, rotation};
        in.tetunsuitable = tetSizing::isLarge;
    }

    std::string switches(how.switches);
    ::tetrahedralize(&switches[0], &in, &out);

    std::fwrite(&out.numberofpoints, sizeof(int), 1, result);
    std::fwrite(&out.numberoftetrahedra, sizeof(int), 1, result);
    std::fwrite(out.pointlist, sizeof(REAL), 3*out.numberofpoints, result);
    std::fwrite
    (
        out.tetrahedronlist, sizeof(int), 4*out.numberoftetrahedra, result
    );
}


static bool read
(
    const tetDomain& domain,
    const tensor& rotation,
    std::FILE* result,
    tetMesh& mesh
)
{
    int sizes[2];

    if (std::fread(sizes, sizeof(int), 2, result) != 2)
    {
        return false;
    }

    static_assert
    (
        sizeof(point) == 3*sizeof(REAL) && sizeof(tetCell) == 4*sizeof(int),
        "points of three doubles and labels of 32 bits"
    );

    mesh.points.setSize(sizes[0]);
    mesh.tets.setSize(sizes[1]);

    const size_t nPoints =
        std::fread(mesh.points.data(), sizeof(point), sizes[0], result);
    const size_t nTets =
        std::fread(mesh.tets.data(), sizeof(tetCell), sizes[1], result);

    // Those of the domain as they were, those that were added turned back
    forAll(mesh.points, p)
    {
        mesh.points[p] = p < domain.points.size()
          ? domain.points[p] : mesh.points[p] & rotation;
    }

    return nPoints == size_t(sizes[0]) && nTets == size_t(sizes[1]);
}


//- Whether all facets are faces of tetrahedra: now and then TetGen adds a point
//  on one
static bool keepsFacets(const tetDomain& domain, const tetMesh& mesh)
{
    const triangleIndex facets(domain.facets);
    boolList isFace(domain.facets.size(), false);

    for (const tetCell& tet : mesh.tets)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label a = tet[(i + 1) % 4];
            const label b = tet[(i + 2) % 4];
            const label c = tet[(i + 3) % 4];

            // Facets are on points of the domain
            if (max(max(a, b), c) < domain.points.size())
            {
                const label facet = facets.find(a, b, c);

                if (facet >= 0)
                {
                    isFace[facet] = true;
                }
            }
        }
    }

    return !isFace.found(false);
}


//- Facets stay as they are: not split (Y), coplanar ones not merged (M), no
//  tolerance (T) in place of the exact predicates. Points that are not used
//  are not left out (J), or the others would change their labels.
static const std::string keepFacets("pYMJQT1e-16");

//- Radius over shortest edge at most 1.3, dihedral angles from 12 to 120
//  degrees, where it can be had, by refinement and then by flips and smoothing
static const std::string shapes("q1.3/12o/120O4/7");


static tetMesh attempts(const tetDomain& domain, const tetRun& how)
{
    for (label attempt = 0; attempt < maxAttempts; ++attempt)
    {
        const tensor rotation(generalRotation(attempt));
        tetMesh mesh;

        const processEnd end = isolatedProcess
        (
            [&](std::FILE* result) { run(domain, how, rotation, result); },
            [&](std::FILE* result)
            {
                return read(domain, rotation, result, mesh);
            },
            max(how.seconds >> attempt, 2)
        );

        if
        (
            end == processEnd::complete && keepsFacets(domain, mesh)
         && (!how.size || allPositive(mesh.points, mesh.tets))
        )
        {
            return mesh;
        }
    }

    FatalErrorInFunction
        << "TetGen failed, or took too long, on "
        << domain.facets.size() << " facets and "
        << domain.points.size() << " points, " << maxAttempts << " times"
        << exit(FatalError);

    return tetMesh();
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool Foam::allPositive(const pointField& x, const tetCellList& tets)
{
    for (const tetCell& tet : tets)
    {
        if (orientation(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) <= 0)
        {
            return false;
        }
    }

    return true;
}


Foam::tetMesh Foam::tetrahedralize(const tetDomain& domain)
{
    return attempts
    (
        domain,
        tetRun{keepFacets, nullptr, 3 + domain.points.size()/16000}
    );
}


Foam::tetMesh Foam::tetrahedralize
(
    const tetDomain& domain,
    const std::function<scalar(const point&)>& size,
    const label maxTets
)
{
    return attempts
    (
        domain,
        tetRun
        {
            keepFacets + shapes + 'S' + std::to_string(maxTets/4),
            size,
            30 + maxTets/3000
        }
    );
}


// ************************************************************************* //
