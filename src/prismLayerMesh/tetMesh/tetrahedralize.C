/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetrahedralize.H"
#include "cellPredicates.H"
#include "error.H"
#include "isolatedProcess.H"
#include "quaternion.H"
#include "ranges.H"
#include "stageProgress.H"
#include "triangleIndex.H"

#include <algorithm>
#include <tetgen.h>

namespace Foam
{

//- The points of a tetrahedron, as TetGen has them
typedef FixedList<int, 4> tetgenCell;


namespace
{

//- Constants that were tuned
const struct
{
    //- How often TetGen is started, each time with other coordinates: where the
    //  first attempts fail, each later one succeeds in about 1 of 3 cases
    label maxAttempts = 12;

    //- CPU time of the first two attempts [s], and the points for which they
    //  have one second more: twice the time of any success. Later attempts have
    //  a quarter of it, but not less than the shortest time.
    label seconds = 3;
    label pointsPerSecond = 16000;
    label shortest = 2;

    //- CPU time of brief attempts [s], with as many points for one second more:
    //  four times the time of most successes
    label brief = 1;

    //- Facets stay as they are: not split (Y), coplanar ones not merged (M), no
    //  tolerance (T) in place of the exact predicates. Points that are not used
    //  are not left out (J): that would change the labels of the others.
    const char* switches = "pYMJQT1e-16";
} tuned;

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


//- Runs TetGen on a domain whose coordinates are rotated, and sends the mesh.
//  TetGen may end the process.
static void runTetgen
(
    const tetDomain& domain,
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

    std::string switches(tuned.switches);
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


//- Returns the mesh that runTetgen has sent, turned back: the points of the
//  domain are as they were
static tetMesh readTetgen
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


//- The rotation of the coordinates of an attempt.
//
//  Rotations lay nothing along the axes or their diagonals: on exactly coplanar
//  and cospherical points TetGen fails now and then, and with other coordinates
//  rarely again. But points in one plane are beside it then by rounding, and
//  between wide flat faces TetGen may need many points, or its flips may not
//  end. So one attempt has the coordinates as they are: the first one if
//  areInPlanes, the second one otherwise.
static tensor rotationOf(const tetDomain& domain, const label attempt)
{
    return attempt == (domain.areInPlanes ? 0 : 1)
      ? tensor(tensor::I)
      : quaternion
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


//- Makes an attempt. Returns whether it succeeded.
//  seconds: bound on its CPU time [s]
static bool makeAttempt
(
    const tetDomain& domain,
    const label attempt,
    const label seconds,
    tetMesh& mesh
)
{
    tellProgress("TetGen, points", domain.points.size());
    const tensor rotation(rotationOf(domain, attempt));
    const processEnd end = isolatedProcess
    (
        [&](pipeWriter& result)
        {
            runTetgen(domain, rotation, result);
        },
        [&](pipeReader& result)
        {
            mesh = readTetgen(domain, rotation, result);
        },
        seconds
    );

    return end == processEnd::complete && keepsFacets(domain, mesh)
        && allPositive(mesh.points, mesh.tets);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool tetrahedralizeBriefly(const tetDomain& domain, tetMesh& mesh)
{
    const label seconds =
        tuned.brief + domain.points.size()/tuned.pointsPerSecond;

    return makeAttempt(domain, 0, seconds, mesh)
        || makeAttempt(domain, 1, seconds, mesh);
}


tetMesh tetrahedralize(const tetDomain& domain)
{
    const label seconds =
        tuned.seconds + domain.points.size()/tuned.pointsPerSecond;
    tetMesh mesh;
    for (label attempt = 0; attempt < tuned.maxAttempts; ++attempt)
    {
        const label most =
            attempt < 2 ? seconds : max(seconds/4, tuned.shortest);
        if (makeAttempt(domain, attempt, most, mesh))
        {
            return mesh;
        }
    }

    FatalErrorInFunction
        << "TetGen failed, or took too long, on "
        << domain.facets.size() << " facets and "
        << domain.points.size() << " points, " << tuned.maxAttempts << " times."
        << " Remesh the surface, or move apart walls that nearly touch"
        << exit(FatalError);

    return mesh;
}


bool allPositive(const UList<point>& x, const UList<tetCell>& tets)
{
    return allOf(tets, [&](const tetCell& tet)
    {
        return orientation(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) > 0;
    });
}

} // End namespace Foam

// ************************************************************************* //
