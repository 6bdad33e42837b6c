/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sectorSearch.H"
#include "DynamicField.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void sectorSearch::setPlanes(const label i, const vector& toNeighbour)
{
    const vector& e = edges_[i];

    planes_[i].first() = normalised(toNeighbour ^ e);
    planes_[i].second() =
        normalised(toNeighbour - (toNeighbour & e)*e);
}


void sectorSearch::setCandidates()
{
    const vectorField& corners = visibility_.cornerNormals[p_];
    scalarField cosines(edges_.size());
    forAll(cosines, i)
    {
        cosines[i] = corners[i] & corners[corners.rcIndex(i)];
    }

    // Not those on the border
    const label nHalf = edges_.size()/2;
    candidates_ = subsetList(sortedOrder(cosines), [&](const label i)
    {
        return !side_ || (i > 0 && i < nHalf);
    });
    const label most = frontControls::maxEdges/(side_ ? 2 : 1);
    candidates_.setSize(min(candidates_.size(), most));
    sort(candidates_);

    if (side_)
    {
        // With their reflections they remain in ascending order
        for (label k = candidates_.size() - 1; k >= 0; --k)
        {
            candidates_.append(edges_.size() - candidates_[k]);
        }
    }
}


void sectorSearch::reflect(vectorField& neighbourDirections)
{
    const label nFaces = normals_.size();

    for (label i = nFaces - 1; i >= 0; --i)
    {
        vectorField reflected(normals_[i].size());
        forAll(reflected, k)
        {
            reflected[k] = side_->reflected(normals_[i][k]);
        }
        normals_.append(reflected);

        if (i > 0)
        {
            edges_.append(side_->reflected(edges_[i]));
            neighbourDirections.append
            (
                side_->reflected(neighbourDirections[i])
            );
        }
    }
}


vectorField sectorSearch::planesOf(const label first, const label last) const
{
    return vectorField
    ({
        planes_[first].first(), planes_[first].second(),
        -planes_[last].first(), planes_[last].second()
    });
}


visibilityCone sectorSearch::cone(const label first, const label last) const
{
    DynamicField<vector> all(planesOf(first, last));

    label i = first;
    do
    {
        all.append(normals_[i]);
        i = normals_.fcIndex(i);
    }
    while (i != last);

    return makeVisibilityCone(all);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sectorSearch::sectorSearch
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const vectorField& neighbourDirections,
    const label p
)
:
    visibility_(visibility),
    p_(p),
    least_
    (
        visibility.cones[p].empty()
      ? 0
      : max
        (
            frontControls::choiceShare*visibility.cones[p].cosine,
            frontControls::smallestChoice
        )
    )
{
    facesAround around(wall, addressing, visibility, p);
    side_ = std::move(around.side);
    edges_.transfer(around.edges);
    normals_.transfer(around.normals);

    vectorField all(neighbourDirections);
    if (side_)
    {
        reflect(all);
    }

    planes_.setSize(edges_.size());
    forAll(edges_, i)
    {
        setPlanes(i, all[i]);
    }

    setCandidates();

    cones_.setSize(candidates_.size());
    forAll(cones_, i)
    {
        cones_[i].setSize(candidates_.size());

        forAll(cones_, j)
        {
            cones_[i][j] = cone(candidates_[i], candidates_[j]);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
