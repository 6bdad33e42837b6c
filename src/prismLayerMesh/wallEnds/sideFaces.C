/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideFaces.H"
#include "disjointSets.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Function>
void sideFaces::forAllPairs(const Function& call) const
{
    for (label e = 0; e < edges_.nEdges(); ++e)
    {
        const SubList<wallSide> both(edges_.on(e));

        if (both.size() == 2)
        {
            call(both[0].facei, both[1].facei);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sideFaces::sideFaces
(
    const wallSurface& surface,
    const labelList& sectors,
    const layerControls& layers
)
:
    surface_(surface),
    sectors_(sectors),
    edges_(makeWallSides(surface)),
    normals_(surface.faceNormals()),
    isSide_(surface.faces.size()),
    atWall_(surface.faces.size())
{
    boolList isSidePatch(surface_.patchNames.size(), false);
    forAll(isSidePatch, patchi)
    {
        isSidePatch[patchi] = layers.isSide(surface_.patchNames[patchi]);
    }

    forAll(surface_.patchIDs, facei)
    {
        isSide_.set(facei, isSidePatch[surface_.patchIDs[facei]]);
    }

    forAllPairs([&](const label f, const label g)
    {
        atWall_.set(f, atWall_.test(f) || !isSide_.test(g));
        atWall_.set(g, atWall_.test(g) || !isSide_.test(f));
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

List<DynamicList<label>> sideFaces::joined
(
    const scalar cosine,
    const labelUList& partOfFace
) const
{
    disjointSets sets(surface_.faces.size());
    forAllPairs([&](const label f, const label g)
    {
        if
        (
            isSide_.test(f) && isSide_.test(g)
         && sectors_[f] == sectors_[g]
         && surface_.patchIDs[f] == surface_.patchIDs[g]
         && (normals_[f] & normals_[g]) > cosine
        )
        {
            sets.join(f, g);
        }
    });

    Map<label> listOf;
    DynamicList<DynamicList<label>> lists;
    for (const label f : isSide_)
    {
        if (partOfFace[f] < 0)
        {
            if (listOf.insert(sets.find(f), lists.size()))
            {
                lists.append(DynamicList<label>());
            }
            lists[listOf[sets.find(f)]].append(f);
        }
    }

    return List<DynamicList<label>>(std::move(lists));
}


bool sideFaces::touchWall(const labelUList& faces) const
{
    return anyOf(faces, [&](const label f) { return atWall_.test(f); });
}


bitSet sideFaces::joinedToWall() const
{
    labelList components;
    bitSet hasWall(findComponents(edges_, isSide_.size(), components));
    forAll(components, facei)
    {
        if (!isSide_.test(facei))
        {
            hasWall.set(components[facei]);
        }
    }

    bitSet joined(components.size());
    forAll(components, facei)
    {
        joined.set(facei, hasWall.test(components[facei]));
    }

    return joined;
}

} // End namespace Foam

// ************************************************************************* //
