/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearestSurface.H"
#include "removeUnused.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A face is along another if the product of their unit normals is larger:
//  cos(10 degrees)
static constexpr scalar alongCosine = 0.985;


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


//- A surface with some of its faces, without their patches
static wallSurface withFaces
(
    const wallSurface& surface,
    const labelUList& kept
)
{
    wallSurface part(surface);
    part.faces = UIndirectList<face>(surface.faces, kept)();
    removeUnusedPoints(part.faces, part.points);

    return part;
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


void nearestSurface::setPatches
(
    wallSurface& other,
    const wordHashSet& onlyAlong
) const
{
    const pointField centres(centresOf(other));
    pointField nearest;
    labelList faces;
    find(centres, nearest, faces);
    other.patchNames = surface_.patchNames;
    other.patchIDs = UIndirectList<label>(surface_.patchIDs, faces)();

    const auto isOnlyAlong = [&](const label patchi)
    {
        return onlyAlong.found(surface_.patchNames[patchi]);
    };
    const vectorField normals(other.faceNormals());
    DynamicList<label> chamfers;
    forAll(faces, facei)
    {
        const face& below = surface_.faces[faces[facei]];

        if
        (
            isOnlyAlong(other.patchIDs[facei])
         && mag(below.unitNormal(surface_.points) & normals[facei])
          < alongCosine
        )
        {
            chamfers.append(facei);
        }
    }

    const labelList kept
    (
        subsetList(identity(surface_.faces.size()), [&](const label facei)
        {
            return !isOnlyAlong(surface_.patchIDs[facei]);
        })
    );

    if (chamfers.size() && kept.size())
    {
        nearestSurface(withFaces(surface_, kept)).find
        (
            pointField(centres, chamfers), nearest, faces
        );
        forAll(chamfers, i)
        {
            other.patchIDs[chamfers[i]] = surface_.patchIDs[kept[faces[i]]];
        }
    }

    mergePatches(other);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

pointField samplesOf(const wallSurface& surface)
{
    pointField samples(surface.points);
    samples.append(centresOf(surface));

    return samples;
}


surfaceDistance distanceTo
(
    const nearestSurface& other,
    const wallSurface& surface
)
{
    const pointField from(samplesOf(surface));
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
