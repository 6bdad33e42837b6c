/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "improveTets.H"
#include "edgeHashes.H"
#include "farFieldMeshControls.H"
#include "labelPair.H"
#include "ListOps.H"
#include "ranges.H"
#include "stageProgress.H"
#include "tetEditor.H"
#include "tetImprover.H"
#include "triangleIndex.H"
#include "UIndirectList.H"

namespace Foam
{

bool isFlat(const UList<point>& x, const tetCell& tet)
{
    scalar longestSqr = 0;
    for (label i = 0; i < 6; ++i)
    {
        longestSqr = max(longestSqr, magSqr(tet.tetEdge(i).vec(x)));
    }

    return mag(tet.tet(x).mag())
      < farFieldTuned.flatVolume*pow(longestSqr, 1.5);
}


//- Returns the numbers of the points opposite to the two triangles of one patch
//  that a flat cell has; {-1, -1} of other cells, and of cells with a triangle
//  of the layers or of the wall
static labelPair flatCorners
(
    const farFieldTets& mesh,
    const triangleIndex& triangles,
    const triangleIndex& outer,
    const tetCell& tet
)
{
    labelPair found(-1, -1);
    if (anyOf(tet, [&](const label p) { return p >= mesh.nBoundaryPoints; }))
    {
        return found;
    }
    label patchi = -1;
    label n = 0;
    for (label i = 0; i < 4; ++i)
    {
        if (outer.found(triFace(tet.face(i))))
        {
            return labelPair(-1, -1);
        }
        const label trianglei = triangles.lookup(triFace(tet.face(i)), -1);
        if (trianglei < 0)
        {
            continue;
        }
        if (++n > 2 || (n == 2 && mesh.patchIDs[trianglei] != patchi))
        {
            return labelPair(-1, -1);
        }
        patchi = mesh.patchIDs[trianglei];
        found[n - 1] = i;
    }

    return n == 2 && isFlat(mesh.points, tet) ? found : labelPair(-1, -1);
}


void removeFlatCells(farFieldTets& mesh)
{
    triangleIndex triangles(makeTriangleIndex(mesh.boundaryTriangles));
    const triangleIndex outer(makeTriangleIndex(mesh.outerTriangles));
    boolList flat(mesh.tets.size(), false);
    for (bool more = true; more;)
    {
        more = false;
        forAll(mesh.tets, t)
        {
            const tetCell& tet = mesh.tets[t];
            const labelPair pair
            (
                flat[t] ? labelPair(-1, -1)
              : flatCorners(mesh, triangles, outer, tet)
            );
            if (pair[0] < 0)
            {
                continue;
            }

            // The triangles opposite to the two points of the common edge
            label k = 0;
            for (const label i : pair)
            {
                const triFace old(tet.face(i));
                while (k == pair[0] || k == pair[1])
                {
                    ++k;
                }
                const triFace made(tet.face(k++));
                const label trianglei = triangles[old];
                triangles.erase(old);
                triangles.insert(made, trianglei);
                mesh.boundaryTriangles[trianglei] = face(made);
            }
            flat[t] = more = true;
        }
    }

    mesh.tets = UIndirectList<tetCell>(mesh.tets, findIndices(flat, false))();
}


//- What cells may not be split at, or are to be split for
struct cornerBounds
{
    //- Triangles of patches and of the layers, those of the cut, and the edges
    //  of all
    triangleIndex triangles;
    triangleIndex cut;
    edgeHashSet edges;
};


//- Returns the edge or face at which a tetrahedron with two or three faces on
//  the boundary is to be split: the edge opposite to two such faces, or a face
//  if there are three or the edge is on the boundary. Other tetrahedra have no
//  such simplex, nor have those between the boundary and the cut: its last
//  point is -1.
static simplex cornerSplit(const tetCell& tet, const cornerBounds& bounds)
{
    // Points opposite to faces on the boundary, and the others
    DynamicList<label> opposite(4);
    DynamicList<label> others(4);

    for (label i = 0; i < 4; ++i)
    {
        const bool isBoundary =
            bounds.triangles.lookup(triFace(tet.face(i)), -1) >= 0;
        (isBoundary ? opposite : others).append(tet[i]);
    }

    if (opposite.size() < 2)
    {
        return sortedSimplex(-1, -1, -1);
    }

    const label a = opposite[0];
    const label b = opposite[1];
    if (opposite.size() == 2 && !bounds.edges.found(edge(a, b)))
    {
        return sortedSimplex(-1, a, b);
    }

    // Points of the faces inside that have both
    DynamicList<label> thirds
    (
        opposite.size() > 2
      ? labelList(1, opposite[2]) : labelList({others[1], others[0]})
    );
    for (const label c : thirds)
    {
        if (bounds.cut.lookup(triFace(a, b, c), -1) < 0)
        {
            return sortedSimplex(c, a, b);
        }
    }

    return sortedSimplex(-1, -1, -1);
}


void splitCornerCells(farFieldTets& mesh)
{
    // Cells whose points are all on the far boundary may be beside the layers,
    // where these end on side patches
    faceList all(mesh.boundaryTriangles);
    all.append(mesh.outerTriangles);
    cornerBounds bounds;
    bounds.triangles = makeTriangleIndex(all);
    bounds.cut = makeTriangleIndex(mesh.cutTriangles);
    all.append(mesh.cutTriangles);
    boolList onBoundary(mesh.points.size(), false);

    for (const face& f : mesh.boundaryTriangles)
    {
        UIndirectList<bool>(onBoundary, f) = true;
    }
    if (!mesh.hasLayers)
    {
        for (const face& f : mesh.outerTriangles)
        {
            UIndirectList<bool>(onBoundary, f) = true;
        }
    }
    for (const face& f : all)
    {
        bounds.edges.insert(f.edges());
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
            const simplex s(cornerSplit(tet, bounds));

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


// * * * * * * * * * * * * * * *  Improve Tets * * * * * * * * * * * * * * * //

void improveTets(const neighbourCells& neighbours, farFieldTets& mesh)
{
    tetImprover improver(neighbours, mesh);
    const label maxPasses = farFieldTuned.maxPasses;
    label pass = 0;

    repeatUntilStable("improving tetrahedra", maxPasses, [&]()
    {
        tellProgress("improving tetrahedra, pass", ++pass, maxPasses);

        return improver.improve();
    });

    mesh.points = improver.points();
    mesh.tets = improver.tets().remaining();
    mesh.neighbours = improver.tets().remainingNeighbours();
}

} // End namespace Foam

// ************************************************************************* //
