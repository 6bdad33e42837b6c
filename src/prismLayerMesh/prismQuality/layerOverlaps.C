/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerOverlaps.H"
#include "prismQuality.H"
#include "sideCrossings.H"
#include "stackExchange.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Notes a pair of findIntersections
static void addPair
(
    const prismLayers& layers,
    const scalarField& thickness,
    const labelPair& pair,
    stackExchange& others,
    DynamicList<overlappingStack>& found
)
{
    const label n = layers.faces.size();
    const auto tallest = [&](const label f)
    {
        return others.isForeign(f) ? others.tallest(f)
          : f >= n ? tallestOf(layers, f - n, thickness) : scalar(0);
    };

    if (others.isForeign(pair.first()))
    {
        // Their processes look for such a pair
        return;
    }

    const scalar height = max(tallest(pair.first()), tallest(pair.second()));
    for (const label f : pair)
    {
        if (others.isForeign(f))
        {
            others.note(f, height);
        }
        else if (f >= n)
        {
            found.append({f - n, height});
        }
    }
}


//- The stacks whose outer faces intersect outer faces or the wall
static DynamicList<overlappingStack> intersectingStacks
(
    const prismLayers& layers,
    const labelUList& outerFaces,
    const stackBoxes& groups,
    const scalarField& thickness,
    const columnTeam& team
)
{
    const labelList own
    (
        subsetList
        (
            outerFaces,
            [&](const label facei) { return team.counts(layers.faces[facei]); }
        )
    );
    stackExchange others(layers, own, groups, thickness, team);
    DynamicList<overlappingStack> found;

    for
    (
        const labelPair& pair
      : findIntersections(layers, own, groups, others.triangles(), team)
    )
    {
        addPair(layers, thickness, pair, others, found);
    }
    found.append(others.tell());

    return found;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar tallestOf
(
    const prismLayers& layers,
    const label facei,
    const scalarField& thickness
)
{
    return max(scalarField(thickness, layers.faces[facei]));
}


List<overlappingStack> findOverlaps
(
    const prismLayers& layers,
    const labelUList& outerFaces,
    const layerBodies& bodies,
    const stackBoxes& groups,
    const scalarField& thickness,
    const columnTeam& team
)
{
    if (!team.any(outerFaces.size()))
    {
        return List<overlappingStack>();
    }

    DynamicList<overlappingStack> found
    (
        intersectingStacks(layers, outerFaces, groups, thickness, team)
    );

    // Stacks that overlap what cannot move
    const auto addAlone = [&](const label facei)
    {
        found.append({facei, tallestOf(layers, facei, thickness)});
    };
    for (const label facei : findSideCrossings(layers, outerFaces, team))
    {
        addAlone(facei);
    }
    for (const labelPair& nested : findNestedBodies(layers, outerFaces, bodies))
    {
        addAlone(nested.second() - layers.faces.size());
    }

    return List<overlappingStack>(std::move(found));
}

} // End namespace Foam

// ************************************************************************* //
