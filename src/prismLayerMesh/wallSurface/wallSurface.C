/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "disjointSets.H"
#include "triSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

vectorField wallSurface::faceNormals() const
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

scalarField meanEdges(const wallSurface& wall, const wallAddressing& addressing)
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


scalar enclosedVolume(const wallSurface& wall)
{
    const point& origin = wall.points[0];
    scalar volume = 0;

    const auto add = [&](const faceList& faces, const pointField& points)
    {
        for (const face& f : faces)
        {
            volume += (f.centre(points) - origin) & f.areaNormal(points);
        }
    };

    add(wall.faces, wall.points);
    for (const sidePatch& side : wall.border.sides)
    {
        add(side.faces, side.points);
    }

    return volume/3;
}


labelList largestFaces(const wallSurface& wall)
{
    disjointSets components(connectedPoints(wall.points.size(), wall.faces));

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


faceList wallTriangles(const wallSurface& wall, labelList& triangleFace)
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


triSurface toTriSurface(const wallSurface& wall)
{
    labelList triangleFace;
    const faceList triangles(wallTriangles(wall, triangleFace));

    List<labelledTri> tris(triangles.size());
    forAll(tris, i)
    {
        const face& f = triangles[i];
        tris[i] = labelledTri(f[0], f[1], f[2], 0);
    }

    return triSurface(tris, wall.points);
}

} // End namespace Foam

// ************************************************************************* //
