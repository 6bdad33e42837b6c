/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "checkFarBoundary.H"
#include "labelledTriangle.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Solid angle over 4 pi under which x sees the triangles: 1 inside of a closed
//  surface whose normals point inwards, 0 outside
static scalar windingNumber
(
    const pointField& points,
    const faceList& triangles,
    const point& x
)
{
    scalar angle = 0;

    for (const face& f : triangles)
    {
        const vector a(points[f[0]] - x);
        const vector b(points[f[1]] - x);
        const vector c(points[f[2]] - x);

        // Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983)
        angle -= 2*::atan2
        (
            a & (b ^ c),
            mag(a)*mag(b)*mag(c) + (a & b)*mag(c) + (b & c)*mag(a)
          + (c & a)*mag(b)
        );
    }

    return angle/(4*constant::mathematical::pi);
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::checkFarBoundary
(
    const wallSurface& outer,
    const pointField& points,
    const farFieldMesh& mesh
)
{
    const label n = mesh.outerTriangles.size();
    DynamicList<labelPair> pairs;
    addIntersections
    (
        labelledTriangles
        (
            mesh.boundaryTriangles, points,
            identity(mesh.boundaryTriangles.size(), n)
        ),
        labelledTriangles(mesh.outerTriangles, points, identity(n)),
        pairs
    );

    if (pairs.size())
    {
        const label facei = pairs[0].second() - n;

        FatalErrorInFunction
            << "The far boundary cuts "
            << (pairs[0].first() < n ? "the layers" : "itself") << " at "
            << pairs.size() << " places, first at "
            << mesh.boundaryTriangles[facei].centre(points) << nl
            << "Move it away from the wall, or make the layers thinner"
            << exit(FatalError);
    }

    for (const label facei : largestFaces(outer))
    {
        const point& x = outer.points[outer.faces[facei][0]];

        if (windingNumber(points, mesh.boundaryTriangles, x) < 0.5)
        {
            FatalErrorInFunction
                << "The far boundary is not around the wall: the layers at "
                << x << " are outside of it" << exit(FatalError);
        }
    }
}


// ************************************************************************* //
