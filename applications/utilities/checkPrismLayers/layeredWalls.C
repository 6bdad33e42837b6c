/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layeredWalls.H"
#include "prismPolyMesh.H"
#include "ranges.H"
#include "wallPolyPatch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void writeBare(const polyPatch& wall, const bitSet& beyond)
{
    const label nBeyond = countOf
    (
        wall.faceCells(), [&](const label celli) { return beyond.test(celli); }
    );

    Info<< "    " << wall.name() << ": of " << wall.size() << " faces "
        << nBeyond << " are beyond the layers, and no stack of layers stands"
        << " on " << wall.size() - nBeyond << nl;
}


//- The patches of which a predicate is true
template<class Predicate>
static labelList patchesThat
(
    const polyBoundaryMesh& patches,
    const Predicate& isTrue
)
{
    DynamicList<label> found;
    for (const polyPatch& patch : patches)
    {
        if (isTrue(patch))
        {
            found.append(patch.index());
        }
    }

    return labelList(std::move(found));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList patchesWithLayers
(
    const polyBoundaryMesh& patches,
    const polyhedralMesh& mesh,
    const bitSet& beyond,
    const labelUList& outer
)
{
    const bitSet outerFaces(mesh.faces().size(), facesOf(patches, outer));
    const labelList layered
    (
        patchesThat(patches, [&](const polyPatch& patch)
        {
            return !polyPatch::constraintType(patch.type())
             && !outer.found(patch.index()) && patch.name() != layerOuterName
             && anyOf
                (
                    identity(patch.size(), patch.start()),
                    [&](const label facei)
                    {
                        return isBelowLayers(mesh, facei, beyond, outerFaces);
                    }
                );
        })
    );

    return layered.size() ? layered
      : patchesThat(patches, [&](const polyPatch& patch)
        {
            return isA<wallPolyPatch>(patch)
             && anyOf
                (
                    patch.faceCells(),
                    [&](const label celli) { return !beyond.test(celli); }
                );
        });
}


void writeBareWalls
(
    const polyBoundaryMesh& patches,
    const labelUList& counted,
    const bitSet& beyond,
    const labelUList& outer
)
{
    if (beyond.empty() && outer.empty())
    {
        Info<< "All patches of type wall count: the mesh has neither a cellZone"
            << ' ' << boundaryLayerName << " nor an outer patch" << nl << endl;
    }

    const labelList bare
    (
        patchesThat(patches, [&](const polyPatch& patch)
        {
            return isA<wallPolyPatch>(patch) && patch.size()
             && !counted.found(patch.index());
        })
    );
    if (bare.size())
    {
        Info<< "Walls without layers, not counted" << nl;
        for (const label patchi : bare)
        {
            writeBare(patches[patchi], beyond);
        }
        Info<< endl;
    }
}


void leaveOutSides
(
    const polyhedralMesh& mesh,
    const labelUList& wallFaces,
    const bitSet& beyond,
    const labelUList& outerFaces,
    labelUList& nLayers
)
{
    const bitSet isOuter(mesh.faces().size(), outerFaces);
    bitSet isBelow(wallFaces.size());
    forAll(wallFaces, i)
    {
        isBelow.set(i, isBelowLayers(mesh, wallFaces[i], beyond, isOuter));
    }

    if (isBelow.any())
    {
        forAll(nLayers, i)
        {
            nLayers[i] = isBelow.test(i) ? nLayers[i] : 0;
        }
    }
}


labelList facesOf(const polyBoundaryMesh& patches, const labelUList& which)
{
    DynamicList<label> faces;

    for (const label patchi : which)
    {
        const polyPatch& patch = patches[patchi];
        faces.append(identity(patch.size(), patch.start()));
    }

    return labelList(std::move(faces));
}

} // End namespace Foam

// ************************************************************************* //
