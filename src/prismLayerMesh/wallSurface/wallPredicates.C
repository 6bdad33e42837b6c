/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include "wallPredicates.H"
#include "labelledTriangle.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef CGAL::Exact_predicates_inexact_constructions_kernel exactKernel;
typedef CGAL::Surface_mesh<exactKernel::Point_3> exactMesh;


static exactMesh toExactMesh
(
    const pointField& points,
    const UList<face>& triangles
)
{
    exactMesh mesh;
    mesh.reserve(points.size(), 3*triangles.size()/2, triangles.size());

    for (const point& p : points)
    {
        mesh.add_vertex(exactKernel::Point_3(p.x(), p.y(), p.z()));
    }

    typedef exactMesh::Vertex_index vertex;

    for (const face& t : triangles)
    {
        mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
    }

    return mesh;
}


//- Whether the face of the mesh runs the other way than the triangle
static bool isTurned
(
    const exactMesh& mesh,
    const exactMesh::Face_index f,
    const face& triangle
)
{
    const exactMesh::Halfedge_index h = mesh.halfedge(f);
    const label a(mesh.source(h));
    const label b(mesh.target(h));

    return triangle[triangle.fcIndex(triangle.find(a))] != b;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<labelPair> findIntersectingFaces
(
    const wallSurface& wall,
    const bitSet& skip
)
{
    labelList triangleFace;
    const faceList triangles(wallTriangles(wall, triangleFace));
    const labelList kept
    (
        subsetList(identity(triangles.size()), [&](const label i)
        {
            return !skip.test(triangleFace[i]);
        })
    );

    DynamicList<labelPair> trianglePairs;
    addIntersections
    (
        labelledTriangles(faceList(triangles, kept), wall.points, kept),
        {},
        trianglePairs
    );

    DynamicList<labelPair> pairs;
    for (const labelPair& pair : trianglePairs)
    {
        const label i = pair.first();
        const label j = pair.second();

        if (!face::sameVertices(triangles[i], triangles[j]))
        {
            pairs.append(labelPair(triangleFace[i], triangleFace[j]));
        }
    }

    // Two polygons can meet in several triangles
    inplaceUniqueSort(pairs);

    return List<labelPair>(std::move(pairs));
}


bitSet findInwardComponents
(
    const wallSurface& wall,
    const labelUList& componentOfFace,
    const label nComponents
)
{
    bitSet inward(nComponents);

    if (nComponents == 1)
    {
        inward.set(0, enclosedVolume(wall) < 0);

        return inward;
    }

    labelList triangleFace;
    const faceList triangles(wallTriangles(wall, triangleFace));
    exactMesh mesh(toExactMesh(wall.points, triangles));
    CGAL::Polygon_mesh_processing::orient_to_bound_a_volume(mesh);

    forAll(triangles, i)
    {
        if (isTurned(mesh, exactMesh::Face_index(i), triangles[i]))
        {
            inward.set(componentOfFace[triangleFace[i]]);
        }
    }

    return inward;
}

} // End namespace Foam

// ************************************************************************* //
