/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/


#include "prismPolyMesh.H"
#include "HashSet.H"

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const Foam::word Foam::layerOuterName("layerOuter");
const Foam::word Foam::layerSidesName("layerSides");


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wordList Foam::prismPatchNames(const wordList& wallPatchNames)
{
    wordHashSet taken;
    taken.insert(layerOuterName);
    taken.insert(layerSidesName);

    wordList names(wallPatchNames);

    for (word& name : names)
    {
        const word asGiven(name);

        for (label i = 2; !taken.insert(name); ++i)
        {
            name = asGiven + Foam::name(i);
        }
    }

    return names;
}


Foam::autoPtr<Foam::polyMesh> Foam::makePrismPolyMesh
(
    prismLayers& layers,
    const IOobject& io
)
{
    polyMeshTopology topology(makePrismTopology(layers));

    wordList names(prismPatchNames(layers.patchNames));
    wordList types(names.size(), word("wall"));

    for (const word& name : {layerOuterName, layerSidesName})
    {
        if (names.size() < topology.patchStarts.size())
        {
            names.append(name);
            types.append(word("patch"));
        }
    }

    pointField points
    (
        layers.furtherRoots.size()
      ? layers.meshPoints() : pointField(std::move(layers.points))
    );
    layers = prismLayers();

    autoPtr<polyMesh> mesh
    (
        new polyMesh
        (
            IOobject
            (
                io.name(),
                io.instance(),
                io.db(),
                IOobject::NO_READ,
                io.writeOpt()
            ),
            std::move(points),
            std::move(topology.faces),
            std::move(topology.owner),
            std::move(topology.neighbour)
        )
    );

    PtrList<polyPatch> patches(names.size());
    forAll(patches, patchi)
    {
        patches.set
        (
            patchi,
            polyPatch::New
            (
                types[patchi],
                names[patchi],
                topology.patchSizes[patchi],
                topology.patchStarts[patchi],
                patchi,
                mesh->boundaryMesh()
            )
        );
    }

    mesh->addPatches(patches);

    return mesh;
}


// ************************************************************************* //
