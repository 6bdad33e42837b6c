/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearestSurface.H"
#include "ListOps.H"
#include "PatchTools.H"
#include "bitSet.H"
#include "primitiveFacePatch.H"
#include "surfacePart.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A face is along another if the product of their unit normals is larger:
//  cos(10 degrees)
static constexpr scalar normalCosine = 0.985;

//- Faces are parts of a plane if the product of their unit normals is larger
static constexpr scalar flatCosine = 1 - 1e-9;


pointField centresOf(const wallSurface& surface)
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


//- Gives each flat part of a surface that consists of some of its faces one
//  patch, the patch with the largest area there
static void unitePatches(const bitSet& faces, wallSurface& surface)
{
    const faceList parts(subset(faces, surface.faces));
    const labelList patchIDs(subset(faces, surface.patchIDs));
    const primitiveFacePatch patch(parts, surface.points);
    const vectorField& normals = patch.faceNormals();
    boolList isBorder(patch.nEdges());
    forAll(isBorder, e)
    {
        const labelList& both = patch.edgeFaces()[e];
        isBorder[e] =
            both.size() != 2
         || (normals[both[0]] & normals[both[1]]) < flatCosine;
    }

    labelList partOf;
    const label nParts = PatchTools::markZones(patch, isBorder, partOf);
    List<Map<scalar>> areas(nParts);
    forAll(parts, i)
    {
        areas[partOf[i]](patchIDs[i], 0) += parts[i].mag(surface.points);
    }

    label i = 0;
    for (const label facei : faces)
    {
        label& patchi = surface.patchIDs[facei];
        const Map<scalar>& ofPart = areas[partOf[i++]];
        forAllConstIters(ofPart, area)
        {
            const scalar most = ofPart[patchi];
            if
            (
                area.val() > most || (area.val() == most && area.key() < patchi)
            )
            {
                patchi = area.key();
            }
        }
    }
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
    bitSet isAcross(faces.size());
    forAll(faces, facei)
    {
        const face& below = surface_.faces[faces[facei]];
        const vector normal(below.unitNormal(surface_.points));

        if (mag(normal & normals[facei]) < normalCosine)
        {
            isAcross.set(facei);
            if (isOnlyAlong(other.patchIDs[facei]))
            {
                chamfers.append(facei);
            }
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
        nearestSurface(makeSurfacePart(surface_, kept).surface).find
        (
            pointField(centres, chamfers), nearest, faces
        );
        forAll(chamfers, i)
        {
            other.patchIDs[chamfers[i]] = surface_.patchIDs[kept[faces[i]]];
        }
    }

    unitePatches(isAcross, other);
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
