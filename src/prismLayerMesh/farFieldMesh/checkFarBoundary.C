/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farBoundary.H"
#include "labelledTriangle.H"
#include "wallSearch.H"

namespace Foam
{

void checkFarBoundary(const wallSurface& outer, const wallSurface& far)
{
    const label n = outer.faces.size();
    std::vector<labelledTriangle> farTriangles
    (
        labelledTriangles(far.faces, far.points, identity(far.faces.size(), n))
    );

    for (labelledTriangle& t : farTriangles)
    {
        for (label& p : t.labels)
        {
            p += outer.points.size();
        }
    }

    DynamicList<labelPair> pairs;
    addIntersections
    (
        farTriangles,
        labelledTriangles(outer.faces, outer.points, identity(n)),
        pairs
    );

    if (pairs.size())
    {
        const face& f = far.faces[pairs[0].second() - n];

        FatalErrorInFunction
            << "The far boundary cuts "
            << (pairs[0].first() < n ? "the layers" : "itself") << " at "
            << pairs.size() << " places, first at "
            << f.centre(far.points) << nl
            << "Move it away from the wall, or make the layers thinner"
            << exit(FatalError);
    }

    const wallSearch search(far);

    for (const label facei : largestFaces(outer))
    {
        const point& x = outer.points[outer.faces[facei][0]];

        if (!search.inFront(x))
        {
            FatalErrorInFunction
                << "The far boundary is not around the wall: the layers at "
                << x << " are outside of it" << exit(FatalError);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
