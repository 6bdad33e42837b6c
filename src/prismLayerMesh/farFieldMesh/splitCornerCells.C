/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "improveTets.H"
#include "edgeHashes.H"
#include "splitTets.H"
#include "triangleIndex.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Returns the edge or face at which a tetrahedron with two or three faces on
//  the boundary is to be split: the edge opposite to two such faces, or a face
//  if there are three or the edge is on the boundary. The triangles and edges
//  of the boundary are given. Other tetrahedra have no such simplex: its last
//  point is -1.
static simplex cornerSplit
(
    const tetCell& tet,
    const triangleIndex& triangles,
    const edgeHashSet& edges
)
{
    DynamicList<label> opposite(4);
    label other = -1;

    for (label i = 0; i < 4; ++i)
    {
        const triFace f(tet.face(i));

        if (triangles.lookup(f, -1) >= 0)
        {
            opposite.append(tet[i]);
        }
        else
        {
            other = tet[i];
        }
    }

    if (opposite.size() < 2)
    {
        return sortedSimplex(-1, -1, -1);
    }

    if (opposite.size() > 2)
    {
        return sortedSimplex(opposite[0], opposite[1], opposite[2]);
    }

    const bool onBoundary = edges.found(edge(opposite[0], opposite[1]));

    return sortedSimplex(onBoundary ? other : -1, opposite[0], opposite[1]);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void splitCornerCells(farFieldMesh& mesh)
{
    // Cells whose points are all on the far boundary may be beside the layers,
    // where these end on side patches
    faceList all(mesh.boundaryTriangles);
    all.append(mesh.outerTriangles);
    const triangleIndex triangles(makeTriangleIndex(all));
    boolList onBoundary(mesh.points.size(), false);
    edgeHashSet edges(4*all.size());

    for (const face& f : mesh.boundaryTriangles)
    {
        UIndirectList<bool>(onBoundary, f) = true;
    }
    for (const face& f : all)
    {
        edges.insert(f.edges());
    }

    simplexSet simplices;
    for (const tetCell& tet : mesh.tets)
    {
        if
        (
            onBoundary[tet[0]] && onBoundary[tet[1]]
         && onBoundary[tet[2]] && onBoundary[tet[3]]
        )
        {
            const simplex s(cornerSplit(tet, triangles, edges));

            if (s[2] >= 0)
            {
                simplices.append(s);
            }
        }
    }
    simplices.sort();

    const label nPoints = mesh.points.size();
    mesh.points.setSize(nPoints + simplices.simplices().size());
    forAll(simplices.simplices(), i)
    {
        mesh.points[nPoints + i] =
            centreOf(simplices.simplices()[i], mesh.points);
    }
    splitTets(simplices, mesh.points, nPoints, mesh.tets);
}

} // End namespace Foam

// ************************************************************************* //
