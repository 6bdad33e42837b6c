/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearestSurface.H"
#include "readWallSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static pointField centresOf(const wallSurface& surface)
{
    pointField centres(surface.faces.size());

    forAll(centres, facei)
    {
        centres[facei] = surface.faces[facei].centre(surface.points);
    }

    return centres;
}


static labelList facesOfTriangles(const wallSurface& surface)
{
    labelList faces;
    wallTriangles(surface, faces);

    return faces;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

nearestSurface::nearestSurface(const wallSurface& surface)
:
    surface_(surface),
    triangleFace_(facesOfTriangles(surface)),
    triangles_(toTriSurface(surface)),
    search_(triangles_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void nearestSurface::find
(
    const pointField& from,
    pointField& nearest,
    labelList& faces
) const
{
    List<pointIndexHit> hits;
    search_.findNearest(from, scalarField(from.size(), sqr(GREAT)), hits);
    nearest.setSize(from.size());
    faces.setSize(from.size());

    forAll(hits, i)
    {
        nearest[i] = hits[i].rawPoint();
        faces[i] = triangleFace_[hits[i].index()];
    }
}


void nearestSurface::setPatches(wallSurface& other) const
{
    pointField nearest;
    labelList faces;
    find(centresOf(other), nearest, faces);
    other.patchNames = surface_.patchNames;
    other.patchIDs = UIndirectList<label>(surface_.patchIDs, faces)();
    mergePatches(other);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

surfaceDistance distanceTo
(
    const nearestSurface& other,
    const wallSurface& surface
)
{
    pointField from(surface.points);
    from.append(centresOf(surface));
    pointField nearest;
    labelList faces;
    other.find(from, nearest, faces);
    surfaceDistance result;

    forAll(from, i)
    {
        const scalar distance = mag(nearest[i] - from[i]);
        result.mean += distance/from.size();

        if (distance > result.largest)
        {
            result.largest = distance;
            result.place = from[i];
        }
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
