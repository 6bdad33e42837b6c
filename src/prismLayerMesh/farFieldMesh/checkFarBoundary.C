/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farBoundary.H"
#include "edgeHashes.H"
#include "labelledTriangle.H"
#include "refineSurface.H"
#include "wallSearch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- An edge with an odd number of faces; not valid if there is none
static edge oddEdge(const faceList& faces)
{
    edgeHashSet odd(3*faces.size());
    for (const face& f : faces)
    {
        for (const edge& e : f.edges())
        {
            if (!odd.insert(e))
            {
                odd.erase(e);
            }
        }
    }

    return odd.size() ? odd.begin().key() : edge();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void checkFarBoundary(const wallSurface& both, const label nOuter)
{
    const label nFar = both.faces.size() - nOuter;
    const auto triangles = [&](const label start, const label n)
    {
        return labelledTriangles
        (
            SubList<face>(both.faces, n, start), both.points,
            identity(n, start)
        );
    };

    DynamicList<labelPair> pairs;
    addIntersections(triangles(nOuter, nFar), triangles(0, nOuter), pairs);

    if (pairs.size())
    {
        const face& f = both.faces[pairs[0].second()];

        FatalErrorInFunction
            << "The far boundary cuts "
            << (pairs[0].first() < nOuter ? "the layers" : "itself") << " at "
            << pairs.size() << " places, first at "
            << f.centre(both.points) << nl
            << "Move it away from the wall, or make the layers thinner"
            << exit(FatalError);
    }

    const edge open(oddEdge(both.faces));
    if (open.valid())
    {
        FatalErrorInFunction
            << "The far boundary is not around the wall: it is open at "
            << open.centre(both.points) << exit(FatalError);
    }

    wallSurface far(both);
    far.faces = SubList<face>(both.faces, nFar, nOuter);
    if (openEdges(far).size())
    {
        return;
    }

    wallSurface outer(both);
    outer.faces.setSize(nOuter);
    const wallSearch search(far);

    for (const label facei : largestFaces(outer))
    {
        const point x(both.faces[facei].centre(both.points));

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
