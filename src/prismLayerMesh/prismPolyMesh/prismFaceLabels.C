/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismFaceLabels.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Sets the sides of a stack to the stacks of higher front faces, on both
static void setInternalSides
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const label facei,
    prismFaceLabels& labels
)
{
    label side = labels.firstFaces[facei];

    visitInternalFaces
    (
        1, faceNeighbours[facei], facei,
        [&](const label k, const label, const label other)
        {
            // The other runs along the edge the other way
            const label end = layers.faces[facei].nextLabel(k);
            const label otherEdge = layers.faces[other].find(end);

            labels.firstSides[facei][k] = side;
            labels.sideStrides[facei][k] = labels.strides[facei];
            labels.firstSides[other][otherEdge] = side;
            labels.sideStrides[other][otherEdge] = labels.strides[facei];
            ++side;
        }
    );
}


//- Sets the first internal face of each stack. Returns the number of internal
//  faces in the mesh.
static label setFirstFaces
(
    const prismLayers& layers,
    const columnTeam& team,
    prismFaceLabels& labels
)
{
    const label n = layers.nLayers;
    const labelList strides(team.faces.onAll(labels.strides));
    labelList firstFaces(strides.size());
    label next = 0;
    forAll(strides, facei)
    {
        firstFaces[facei] = next;
        next += n*strides[facei] - 1;
    }

    labels.firstFaces.setSize(layers.faces.size());
    forAll(labels.firstFaces, facei)
    {
        labels.firstFaces[facei] = firstFaces[team.wholeFace(facei)];
    }

    return next;
}


//- Sets the faces on the patches of the wall, of which the first one is 'next'.
//  Returns the first face behind them.
static label setWallFaces
(
    const prismLayers& layers,
    label next,
    const columnTeam& team,
    prismFaceLabels& labels
)
{
    labelList patches(layers.faces.size(), -1);
    SubList<label>(patches, layers.nWallFaces()) = layers.patchIDs;
    labelList wallFaces(team.faces.onAll(patches));

    for (const labelList& ofPatch : invertOneToMany
        (
            layers.patchNames.size(), wallFaces
        ))
    {
        for (const label facei : ofPatch)
        {
            wallFaces[facei] = next++;
        }
    }

    labels.wallFaces.setSize(layers.nWallFaces());
    forAll(labels.wallFaces, facei)
    {
        labels.wallFaces[facei] = wallFaces[team.wholeFace(facei)];
    }

    return next;
}


//- As setWallFaces, for the faces on layerOuter
static label setOuterFaces
(
    const prismLayers& layers,
    const label first,
    const columnTeam& team,
    prismFaceLabels& labels
)
{
    labels.outerFaces.setSize(layers.faces.size());
    forAll(labels.outerFaces, facei)
    {
        labels.outerFaces[facei] = first + team.wholeFace(facei);
    }

    return first + team.faces.nWhole(layers.faces.size());
}


//- Sets the sides on open edges, of which the first one is 'next'
static void setOpenSides
(
    const UList<DynamicList<labelPair>>& open,
    label next,
    const columnTeam& team,
    prismFaceLabels& labels
)
{
    for (const auto& edges : open)
    {
        List<labelPair> whole(edges);
        for (labelPair& e : whole)
        {
            e.first() = team.wholeFace(e.first());
        }
        List<labelPair> all(team.gather(whole));
        std::sort(all.begin(), all.end());

        forAll(edges, i)
        {
            const label at =
                std::lower_bound(all.begin(), all.end(), whole[i])
              - all.begin();
            const label facei = edges[i].first();
            const label k = edges[i].second();
            labels.firstSides[facei][k] = next + at*labels.nLayers;
            labels.sideStrides[facei][k] = 1;
        }
        next += all.size()*labels.nLayers;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label prismFaceLabels::operator()
(
    const label facei,
    const label k,
    const label i
) const
{
    if (k >= 0)
    {
        const label stride = sideStrides[facei][k];

        return firstSides[facei][k] + (i - 1)*stride
          + (stride > 1 && i < nLayers);
    }

    return
        i == 0 ? wallFaces[facei]
      : i == nLayers ? outerFaces[facei]
      : firstFaces[facei] + (i - 1)*strides[facei];
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismFaceLabels makePrismFaceLabels
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const UList<DynamicList<labelPair>>& open,
    const columnTeam& team
)
{
    prismFaceLabels labels;
    labels.nLayers = layers.nLayers;
    labels.strides.setSize(layers.faces.size());
    forAll(labels.strides, facei)
    {
        labels.strides[facei] =
            1 + nHigherNeighbours(faceNeighbours[facei], facei);
    }

    // As many as there are edges
    labels.firstSides = faceNeighbours;
    labels.sideStrides = faceNeighbours;

    label next = setFirstFaces(layers, team, labels);
    forAll(faceNeighbours, facei)
    {
        if (team.counts(layers.faces[facei]))
        {
            setInternalSides(layers, faceNeighbours, facei, labels);
        }
    }
    next = setWallFaces(layers, next, team, labels);
    next = setOuterFaces(layers, next, team, labels);
    setOpenSides(open, next, team, labels);

    return labels;
}

} // End namespace Foam

// ************************************************************************* //
