/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "replacedPatches.H"
#include "wallSearch.H"

namespace Foam
{

//- The wall below the layers, in triangles whose regions are its patches
static triSurface wallOf(const prismLayers& layers)
{
    DynamicList<labelledTri> triangles(2*layers.nWallFaces());
    forAll(layers.patchIDs, facei)
    {
        const face& f = layers.faces[facei];
        for (label k = 1; k + 1 < f.size(); ++k)
        {
            triangles.append
            (
                labelledTri(f[0], f[k], f[k + 1], layers.patchIDs[facei])
            );
        }
    }

    return triSurface(triangles, layers.pointsOf(0));
}


//- The area of each patch of the core (row) that each patch of the wall
//  (column) is nearest to [m^2]
static List<scalarField> nearestAreas
(
    const prismLayers& layers,
    const polyMeshParts& core,
    const wordList& wallPatches
)
{
    const triSurface wall(wallOf(layers));
    const triangleTree tree(wall);
    List<scalarField> areas
    (
        core.patches.names.size(),
        scalarField(layers.patchNames.size(), Zero)
    );
    for (const word& name : wallPatches)
    {
        const label patchi = core.patches.names.find(name);
        for (const label facei : core.topology.patchFaces(patchi))
        {
            const face& f = core.topology.faces[facei];
            const pointIndexHit foot
            (
                tree.nearest(f.centre(core.points), sqrt(GREAT))
            );
            if (foot.hit())
            {
                areas[patchi][wall[foot.index()].region()] +=
                    f.mag(core.points);
            }
        }
    }

    return areas;
}


labelList replacedPatches
(
    const prismLayers& layers,
    const polyMeshParts& core,
    const wordList& wallPatches
)
{
    labelList replaced(layers.patchNames.size(), -1);
    if (wallPatches.empty())
    {
        return replaced;
    }

    const List<scalarField> areas(nearestAreas(layers, core, wallPatches));
    forAll(areas, patchi)
    {
        const scalarField& area = areas[patchi];
        const label nearest = area.size() ? findMax(area) : -1;
        if (nearest < 0 || 2*area[nearest] <= sum(area))
        {
            continue;
        }
        scalar ofAll = 0;
        for (const scalarField& other : areas)
        {
            ofAll += other[nearest];
        }
        if (2*area[nearest] > ofAll)
        {
            replaced[nearest] = patchi;
        }
    }

    return replaced;
}

} // End namespace Foam

// ************************************************************************* //
