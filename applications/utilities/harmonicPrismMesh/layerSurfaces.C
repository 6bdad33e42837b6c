/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerSurfaces.H"
#include "ListOps.H"
#include "prismPolyMesh.H"
#include "sidePatchRemainders.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

MeshedSurface<face> toMeshedSurface(const wallSurface& surface)
{
    const labelListList patchFaces
    (
        invertOneToMany(surface.patchNames.size(), surface.patchIDs)
    );
    faceList faces;
    List<surfZone> zones(patchFaces.size());

    forAll(patchFaces, patchi)
    {
        zones[patchi] = surfZone
        (
            surface.patchNames[patchi], patchFaces[patchi].size(),
            faces.size(), patchi
        );
        faces.append(UIndirectList<face>(surface.faces, patchFaces[patchi])());
    }

    return MeshedSurface<face>
    (
        pointField(surface.points), std::move(faces), zones
    );
}


MeshedSurface<face> toMeshedSurface(const outerSurface& surface)
{
    return MeshedSurface<face>
    (
        pointField(surface.points),
        faceList(surface.faces),
        List<surfZone>(1, surfZone(layerOuterName, surface.faces.size(), 0, 0))
    );
}


wallSurface sideSurface(const prismLayers& layers)
{
    return makeFarFieldBoundary
    (
        layers, farBoundary(), [](const point&) { return GREAT; }
    ).surface;
}


bool endOnParts(const prismLayers& layers)
{
    const List<sidePatch>& sides = layers.border.sides;

    return sides.size() && !hasPlanes(sides);
}

} // End namespace Foam

// ************************************************************************* //
