/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <tetgen.h>

#include "tetgenRun.H"
#include "isolatedProcess.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Longest edge of a tetrahedron over the size at its centre: tuned
static constexpr scalar maxLength = 1.6;

//- The points of a tetrahedron, as TetGen has them
typedef FixedList<int, 4> corners;


//- Corners of a tetrahedron of TetGen
typedef FixedList<int, 4> tetgenCell;


namespace
{

//- The wanted sizes, and the rotation of the coordinates, in TetGen's process
struct tetSizing
{
    std::function<scalar(const point&)> size;
    tensor rotation;
};

//- Global because TetGen asks with coordinates alone
tetSizing sizing;

} // End anonymous namespace


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
        std::copy(facets[i].begin(), facets[i].end(), polygon.vertexlist);
        io.facetmarkerlist[i] = 1;
    }
}


static bool isLarge(REAL* a, REAL* b, REAL* c, REAL* d, REAL*, REAL)
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
        longest > sqr(maxLength*sizing.size(centre & sizing.rotation));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void runTetgen
(
    const tetDomain& domain,
    const tetgenOptions& options,
    const tensor& rotation,
    pipeWriter& result
)
{
    tetgenio in, out;

    in.numberofpoints = domain.points.size();
    in.pointlist = newCoordinates(domain.points, rotation);
    in.numberofholes = domain.holes.size();
    in.holelist = newCoordinates(domain.holes, rotation);
    setFacets(in, domain.facets);

    if (options.size)
    {
        sizing = tetSizing{options.size, rotation};
        in.tetunsuitable = isLarge;
    }

    std::string switches(options.switches);
    ::tetrahedralize(&switches[0], &in, &out);

    static_assert(sizeof(point) == 3*sizeof(REAL), "points of three doubles");

    result
    (
        UList<point>
        (
            reinterpret_cast<point*>(out.pointlist), out.numberofpoints
        ),
        UList<tetgenCell>
        (
            reinterpret_cast<tetgenCell*>(out.tetrahedronlist),
            out.numberoftetrahedra
        )
    );
}


tetMesh readTetgen
(
    const tetDomain& domain,
    const tensor& rotation,
    pipeReader& result
)
{
    tetMesh mesh;
    List<tetgenCell> tets;
    result(mesh.points, tets);

    mesh.tets.setSize(tets.size());
    forAll(mesh.tets, t)
    {
        std::copy(tets[t].begin(), tets[t].end(), mesh.tets[t].begin());
    }

    // Points of the domain as they were, added points turned back
    forAll(mesh.points, p)
    {
        mesh.points[p] = p < domain.points.size()
          ? domain.points[p] : mesh.points[p] & rotation;
    }

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
