/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boundaryTets.H"
#include "SubList.H"
#include "triangleIndex.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Map<DynamicList<label>> boundaryTets::cutTriangles() const
{
    Map<DynamicList<label>> ofTets(2*onCut.size());
    forAll(onCut, i)
    {
        ofTets(onCut[i]).append(i);
    }

    return ofTets;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

boundaryTets findBoundaryTets(const farFieldTets& tets)
{
    faceList triangles(tets.outerTriangles);
    triangles.append(tets.boundaryTriangles);
    triangles.append(tets.cutTriangles);
    const triangleIndex index(makeTriangleIndex(triangles));
    labelList found(triangles.size(), -1);

    forAll(tets.tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (tets.neighbours[t][i] < 0)
            {
                found[index[tets.tets[t].face(i)]] = t;
            }
        }
    }

    const label n = tets.outerTriangles.size();
    const label m = tets.boundaryTriangles.size();

    return boundaryTets
    {
        SubList<label>(found, n),
        SubList<label>(found, m, n),
        SubList<label>(found, tets.cutTriangles.size(), n + m)
    };
}

} // End namespace Foam

// ************************************************************************* //
