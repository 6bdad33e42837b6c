/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutReflexFaces.H"
#include "DynamicList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Smallest cosine between the normals of a corner and of its face
static const scalar smallestCosine = 0.5;


static bool hasReflexOrFoldedCorner(const face& f, const pointField& points)
{
    const vector normal(normalised(f.areaNormal(points)));

    forAll(f, i)
    {
        const vector next = points[f.nextLabel(i)] - points[f[i]];
        const vector prev = points[f.prevLabel(i)] - points[f[i]];

        const vector corner(next ^ prev);

        if ((corner & normal) <= smallestCosine*mag(corner))
        {
            return true;
        }
    }

    return false;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

label cutFaces(wallSurface& wall, const boolList& isCut)
{
    if (!isCut.found(true))
    {
        return 0;
    }

    DynamicList<face> kept(wall.faces.size()), triangles;
    DynamicList<label> keptIDs(wall.faces.size()), triangleIDs;

    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];
        if (!isCut[facei])
        {
            kept.append(f);
            keptIDs.append(wall.patchIDs[facei]);
            continue;
        }

        faceList parts(f.nTriangles());
        label n = 0;
        f.triangles(wall.points, n, parts);

        for (const face& part : parts)
        {
            triangles.append(part);
            triangleIDs.append(wall.patchIDs[facei]);
        }
    }

    const label nCut = wall.faces.size() - kept.size();
    kept.append(triangles);
    keptIDs.append(triangleIDs);
    wall.faces.transfer(kept);
    wall.patchIDs.transfer(keptIDs);

    return nCut;
}


label cutReflexFaces(wallSurface& wall)
{
    boolList isCut(wall.faces.size());

    forAll(isCut, facei)
    {
        const face& f = wall.faces[facei];

        // One without area is left for findWallDefects
        isCut[facei] = f.size() > 3 && f.mag(wall.points) >= VSMALL
         && hasReflexOrFoldedCorner(f, wall.points);
    }

    return cutFaces(wall, isCut);
}

} // End namespace Foam

// ************************************************************************* //
