/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include "wrapSurface.H"
#include "cgalMeshes.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef CGAL::Exact_predicates_inexact_constructions_kernel wrapKernel;
typedef CGAL::Surface_mesh<wrapKernel::Point_3> wrapMesh;

//- Triangles of a wrap, at most: each takes about 1.7 kB
static constexpr scalar maxTriangles = 5e6;


//- Refuse sizes that would take all memory
static void checkSize(const wallSurface& surface, const scalar size)
{
    scalar area = 0;
    for (const face& f : surface.faces)
    {
        area += f.mag(surface.points);
    }

    // Equilateral, with edges of the size
    const scalar nTriangles = 2*area/sqr(size);

    if (nTriangles > maxTriangles)
    {
        FatalErrorInFunction
            << "A wrap of the size " << size << " m would have about "
            << nTriangles << " triangles. At most " << maxTriangles
            << " are allowed: set surface.wrapCoeffs.size to "
            << Foam::sqrt(2*area/maxTriangles) << " or more"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallSurface wrapSurface
(
    const wallSurface& surface,
    const scalar size,
    const scalar offset,
    const pointField& seeds
)
{
    checkSize(surface, size);

    wrapMesh mesh;
    auto seedPoints = cgalPoints<wrapKernel::Point_3>(seeds);
    labelList triangleFace;

    // CGAL 5.5 reads the parameters of the output, CGAL 6.0 those of the input
    const auto atSeeds = CGAL::parameters::seed_points(std::ref(seedPoints));
    CGAL::alpha_wrap_3
    (
        cgalPoints<wrapKernel::Point_3>(surface.points),
        cgalPolygons(wallTriangles(surface, triangleFace)),
        size, offset, mesh, atSeeds, atSeeds
    );

    if (mesh.is_empty())
    {
        FatalErrorInFunction
            << "A wrap of the size " << size << " m and the offset " << offset
            << " m is empty";

        if (seeds.size())
        {
            FatalError
                << nl << "It begins at the seeds " << seeds << ". Around one of"
                << " them there must be room of about twice the size";
        }

        FatalError << exit(FatalError);
    }

    wallSurface wrap;
    setFaces(mesh, wrap);
    wrap.patchIDs.setSize(wrap.faces.size(), 0);
    wrap.patchNames = wordList(1, word("wall"));

    return wrap;
}

} // End namespace Foam

// ************************************************************************* //
