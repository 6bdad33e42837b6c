/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "normalSectors.H"
#include "sectorSearch.H"

#include <algorithm>

namespace Foam
{

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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool sectorSearch::makeTriangles
(
    const vectorField& axes,
    faceList& triangles
) const
{
    if (!side_)
    {
        return cutIntoTriangles(axes, triangles);
    }

    // On the wall: the last sector, and the first ones up to the middle
    const label n = axes.size();
    vectorField onWall(n/2 + 1);
    onWall[0] = axes[n - 1];
    SubList<vector>(onWall, n/2, 1) = SubList<vector>(axes, n/2);

    if (!cutIntoTriangles(onWall, triangles))
    {
        return false;
    }

    const label nOnWall = triangles.size();
    for (label i = 0; i < nOnWall; ++i)
    {
        face reflected(3);
        forAll(reflected, k)
        {
            const label s = (triangles[i][k] + n - 1) % n;
            triangles[i][k] = s;
            reflected[2 - k] = s == n - 1 ? s : n - 2 - s;
        }
        triangles.append(reflected);
    }

    return true;
}


normalSectors sectorSearch::half(const normalSectors& all) const
{
    const label n = all.starts.size();
    normalSectors sectors;
    sectors.starts.append(0);
    sectors.axes.append(all.axes[n - 1]);
    sectors.planes.append(all.planes[n - 1]);

    for (label s = 0; s < n/2; ++s)
    {
        sectors.starts.append(all.starts[s]);
        sectors.axes.append(all.axes[s]);
        sectors.planes.append(all.planes[s]);
    }

    for (label i = 0; i < all.triangles.size()/2; ++i)
    {
        sectors.triangles.append(all.triangles[i]);
        for (label& s : sectors.triangles.last())
        {
            s = (s + 1) % n;
        }
    }

    return sectors;
}

label normalSectors::sector(const label i) const
{
    // Faces before the first start are of the last sector
    const label s =
        std::upper_bound(starts.begin(), starts.end(), i) - starts.begin();

    return s ? s - 1 : starts.size() - 1;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

normalSectors makeNormalSectors
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const vectorField& neighbourDirections,
    const label p
)
{
    // On two side patches a column can only stand on the line of both
    return addressing.sidesOf(p).size() > 1
      ? normalSectors()
      : sectorSearch
        (
            wall, addressing, visibility, neighbourDirections, p
        ).best();
}

} // End namespace Foam

// ************************************************************************* //
