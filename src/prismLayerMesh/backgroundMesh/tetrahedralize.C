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

#include <algorithm>

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


static void run
(
    const tetDomain& domain,
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

    // Facets stay as they are: not split (Y), coplanar ones not merged (M), no
    // tolerance (T) in place of the exact predicates. Points that are not used
    // are not left out (J), or the others would change their labels.
    char switches[] = "pYMJQT1e-16";
    ::tetrahedralize(switches, &in, &out);

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


typedef FixedList<label, 3> triple;

static triple sortedTriple(const label a, const label b, const label c)
{
    triple t;
    t[0] = a;
    t[1] = b;
    t[2] = c;
    std::sort(t.begin(), t.end());

    return t;
}


//- Whether all facets are faces of tetrahedra: now and then TetGen adds a point
//  on one
static bool keepsFacets(const tetDomain& domain, const tetMesh& mesh)
{
    // Each facet with its smallest point
    labelListList facetsOf(domain.points.size());
    List<triple> facets(domain.facets.size());
    forAll(facets, i)
    {
        const face& f = domain.facets[i];
        facets[i] = sortedTriple(f[0], f[1], f[2]);
        facetsOf[facets[i][0]].append(i);
    }

    boolList isFace(facets.size(), false);

    for (const tetCell& tet : mesh.tets)
    {
        for (label i = 0; i < 4; ++i)
        {
            const triple t
            (
                sortedTriple(tet[(i + 1)%4], tet[(i + 2)%4], tet[(i + 3)%4])
            );

            if (t[0] < facetsOf.size())
            {
                for (const label facet : facetsOf[t[0]])
                {
                    isFace[facet] = isFace[facet] || facets[facet] == t;
                }
            }
        }
    }

    return !isFace.found(false);
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::tetMesh Foam::tetrahedralize(const tetDomain& domain)
{
    for (label attempt = 0; attempt < maxAttempts; ++attempt)
    {
        const tensor rotation(generalRotation(attempt));
        const label seconds = 3 + domain.points.size()/16000;
        tetMesh mesh;

        const processEnd end = isolatedProcess
        (
            [&](std::FILE* result) { run(domain, rotation, result); },
            [&](std::FILE* result)
            {
                return read(domain, rotation, result, mesh);
            },
            max(seconds >> attempt, 2)
        );

        if (end == processEnd::complete && keepsFacets(domain, mesh))
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


// ************************************************************************* //
