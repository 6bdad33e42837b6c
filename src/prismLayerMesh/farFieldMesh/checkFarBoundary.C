/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farBoundary.H"
#include "disjointSets.H"
#include "labelledTriangle.H"
#include "wallSearch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Sets to false what is said of the bodies of faces that are inside of a solid
//  body. solids and cavities: a face of each of these bodies.
static void removeEnclosed
(
    const wallSurface& outer,
    const labelUList& solids,
    const labelUList& cavities,
    disjointSets& bodyOf,
    bitSet& isAround
)
{
    if (cavities.empty())
    {
        return;
    }

    for (const label solid : solids)
    {
        const label body = bodyOf.find(outer.faces[solid][0]);
        wallSurface one(outer);
        one.faces = subsetList
        (
            outer.faces,
            [&](const face& f) { return bodyOf.find(f[0]) == body; }
        );
        const wallSearch search(one);

        for (const label facei : cavities)
        {
            const face& f = outer.faces[facei];
            if (!search.inFront(f.centre(outer.points)))
            {
                isAround.unset(bodyOf.find(f[0]));
            }
        }
    }
}


//- Whether each triangle of the outer surface of the layers is of a body that
//  is around the fluid: the body is not closed, or its normals point inwards,
//  and it is no cavity of another body
static boolList aroundFluid(const wallSurface& outer)
{
    disjointSets bodyOf(connectedPoints(outer.points.size(), outer.faces));
    scalarField volumes(outer.points.size(), 0);
    for (const face& f : outer.faces)
    {
        const label body = bodyOf.find(f[0]);
        volumes[body] += (outer.points[f[0]] - outer.points[body])
          & f.areaNormal(outer.points);
    }
    bitSet isAround(outer.points.size());
    for (const edge& e : outline(outer.faces))
    {
        isAround.set(bodyOf.find(e.start()));
    }

    DynamicList<label> solids, inward;
    for (const label facei : largestFaces(outer))
    {
        const label body = bodyOf.find(outer.faces[facei][0]);
        if (!isAround.test(body))
        {
            (volumes[body] < 0 ? inward : solids).append(facei);
        }
    }
    for (const label facei : inward)
    {
        isAround.set(bodyOf.find(outer.faces[facei][0]));
    }
    removeEnclosed(outer, solids, inward, bodyOf, isAround);

    boolList result(outer.faces.size());
    forAll(result, i)
    {
        result[i] = isAround.test(bodyOf.find(outer.faces[i][0]));
    }

    return result;
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

    const edgeList open(outline(both.faces));
    if (open.size())
    {
        FatalErrorInFunction
            << "The far boundary is not around the wall: it is open at "
            << open[0].centre(both.points) << exit(FatalError);
    }

    checkBodies(both, nOuter);
}


void checkBodies(const wallSurface& both, const label nOuter)
{
    wallSurface outer(both);
    outer.faces.setSize(nOuter);
    const boolList isAround(aroundFluid(outer));
    wallSurface around(both);
    around.faces = subset(isAround, outer.faces);
    around.faces.append
    (
        SubList<face>(both.faces, both.faces.size() - nOuter, nOuter)
    );
    if (around.faces.empty())
    {
        return;
    }

    const wallSearch search(around);
    for (const label facei : largestFaces(outer))
    {
        const point x(outer.faces[facei].centre(both.points));

        if (!isAround[facei] && !search.inFront(x))
        {
            FatalErrorInFunction
                << "The far boundary is not around the wall: the body at " << x
                << " is outside of the fluid, whose boundary is "
                << search.footOf(x).distance << " from it" << exit(FatalError);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
