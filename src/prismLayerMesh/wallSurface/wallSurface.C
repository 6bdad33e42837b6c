/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "disjointSets.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A corner of a face at a point: the points after and before it
struct wallCorner
{
    label next;
    label previous;
    label facei;
};


//- Corners by point: those of p are corners[starts[p]..starts[p+1]-1]
struct wallCorners
{
    labelList starts;
    List<wallCorner> corners;
};


static wallCorners makeCorners(const wallSurface& wall)
{
    wallCorners result;
    labelList& starts = result.starts;
    starts.setSize(wall.points.size() + 1);
    starts = Zero;

    for (const face& f : wall.faces)
    {
        for (const label p : f)
        {
            ++starts[p + 1];
        }
    }

    forAll(wall.points, p)
    {
        starts[p + 1] += starts[p];
    }

    result.corners.setSize(starts.last());
    labelList next(starts);

    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];

        forAll(f, i)
        {
            result.corners[next[f[i]]++] =
                {f[f.fcIndex(i)], f[f.rcIndex(i)], facei};
        }
    }

    return result;
}


//- Each corner after the one that ends on the edge where it begins
static void sortByRotation(wallCorners& c, const label p)
{
    for (label i = c.starts[p] + 1; i < c.starts[p + 1]; ++i)
    {
        for (label j = i; j < c.starts[p + 1]; ++j)
        {
            if (c.corners[j].next == c.corners[i - 1].previous)
            {
                std::swap(c.corners[i], c.corners[j]);
                break;
            }
        }
    }
}


//- The face that runs from a to b; -1 where there is none
static label faceAlong(const wallCorners& c, const label a, const label b)
{
    for (label i = c.starts[a]; i < c.starts[a + 1]; ++i)
    {
        if (c.corners[i].next == b)
        {
            return c.corners[i].facei;
        }
    }

    return -1;
}


static void setEdges(const wallCorners& c, wallAddressing& addressing)
{
    DynamicList<edge> edges(c.corners.size()/2);
    DynamicList<labelPair> edgeFaces(c.corners.size()/2);

    for (label a = 0; a < c.starts.size() - 1; ++a)
    {
        for (label i = c.starts[a]; i < c.starts[a + 1]; ++i)
        {
            const label b = c.corners[i].next;
            const label other = faceAlong(c, b, a);

            if (a < b || other < 0)
            {
                edges.append(edge(a, b));
                edgeFaces.append(labelPair(c.corners[i].facei, other));
            }
        }
    }

    addressing.edges.transfer(edges);
    addressing.edgeFaces.transfer(edgeFaces);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vectorField Foam::wallSurface::faceNormals() const
{
    vectorField normals(faces.size());

    forAll(faces, i)
    {
        const vector area(faces[i].areaNormal(points));
        const scalar size = mag(area);
        normals[i] = (size > 0 ? area/size : vector::zero);
    }

    return normals;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallAddressing Foam::makeWallAddressing(const wallSurface& wall)
{
    const label nPoints = wall.points.size();
    wallCorners c(makeCorners(wall));

    wallAddressing addressing;
    setEdges(c, addressing);

    addressing.pointFaces.setSize(nPoints);
    addressing.pointPoints.setSize(nPoints);

    for (label p = 0; p < nPoints; ++p)
    {
        sortByRotation(c, p);

        const label start = c.starts[p];
        const label n = c.starts[p + 1] - start;
        labelList& faces = addressing.pointFaces[p];
        labelList& points = addressing.pointPoints[p];
        faces.setSize(n);
        points.setSize(n);

        for (label i = 0; i < n; ++i)
        {
            faces[i] = c.corners[start + i].facei;
            points[i] = c.corners[start + i].next;
        }
    }

    return addressing;
}


Foam::scalarField Foam::meanEdges
(
    const wallSurface& wall,
    const wallAddressing& addressing
)
{
    scalarField means(wall.points.size(), 0);

    forAll(means, p)
    {
        const labelList& neighbours = addressing.pointPoints[p];

        for (const label q : neighbours)
        {
            means[p] += mag(wall.points[q] - wall.points[p])/neighbours.size();
        }
    }

    return means;
}


Foam::labelList Foam::largestFaces(const wallSurface& wall)
{
    disjointSets components(wall.points.size());
    for (const face& f : wall.faces)
    {
        for (const label p : f)
        {
            components.join(f[0], p);
        }
    }

    labelList largest(wall.points.size(), -1);
    scalarField areas(wall.points.size(), -1);

    forAll(wall.faces, facei)
    {
        const label component = components.find(wall.faces[facei][0]);
        const scalar area = wall.faces[facei].mag(wall.points);

        if (area > areas[component])
        {
            areas[component] = area;
            largest[component] = facei;
        }
    }

    return subsetList(largest, [](const label facei) { return facei >= 0; });
}


Foam::faceList Foam::wallTriangles
(
    const wallSurface& wall,
    labelList& triangleFace
)
{
    label nTriangles = 0;

    for (const face& f : wall.faces)
    {
        nTriangles += max(label(0), f.size() - 2);
    }

    faceList triangles(nTriangles, face(3));
    triangleFace.setSize(nTriangles);

    label i = 0;
    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];

        for (label j = 2; j < f.size(); ++j)
        {
            face& t = triangles[i];
            t[0] = f[0];
            t[1] = f[j - 1];
            t[2] = f[j];
            triangleFace[i++] = facei;
        }
    }

    return triangles;
}


// ************************************************************************* //
