/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sectorSearch.H"
#include "directionTriangles.H"
#include "mathematicalConstants.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool sectorSearch::isSymmetric(const unsigned bits) const
{
    if (!side_)
    {
        return true;
    }

    const label n = candidates_.size();
    bool same = true;

    for (label k = 0; k < n/2; ++k)
    {
        same = same
            && bool(bits & (1u << k)) == bool(bits & (1u << (n - 1 - k)));
    }

    return same;
}


bool sectorSearch::closes
(
    const labelList& starts,
    const vectorField& d,
    const faceList& triangles
) const
{
    scalarField angles(d.size(), 0);

    forAll(starts, s)
    {
        const label before = starts.rcIndex(s);
        const label after = starts.fcIndex(s);
        const label last = starts[after];

        label i = starts[s];
        angles[s] += angleAt(d[s], d[before], edges_[i]);

        do
        {
            const label next = edges_.fcIndex(i);
            angles[s] += angleAt(d[s], edges_[i], edges_[next]);
            i = next;
        }
        while (i != last);

        angles[s] += angleAt(d[s], edges_[i], d[after]);
    }

    addAngles(d, triangles, angles);

    return max(mag(angles - constant::mathematical::twoPi))
      < frontControls::angleTolerance;
}


void sectorSearch::consider
(
    const unsigned bits,
    scalar& best,
    normalSectors& sectors
)
{
    DynamicList<label> chosen;
    forAll(candidates_, k)
    {
        if (bits & (1u << k))
        {
            chosen.append(k);
        }
    }

    const label n = chosen.size();
    labelList starts(n);
    vectorField axes(n);
    scalar narrowest = GREAT;

    forAll(chosen, s)
    {
        const visibilityCone& c = cones_[chosen[s]][chosen.fcValue(s)];
        starts[s] = candidates_[chosen[s]];
        axes[s] = c.axis;
        narrowest = min(narrowest, c.cosine);
    }

    const scalar score =
        narrowest/::pow(1 + frontControls::sectorGain, n - 2);
    faceList triangles;

    if
    (
        narrowest > least_
     && score > best
     && makeTriangles(axes, triangles)
     && closes(starts, axes, triangles)
    )
    {
        best = score;
        sectors.starts = starts;
        sectors.axes = axes;
        sectors.triangles = triangles;
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

normalSectors sectorSearch::best()
{
    normalSectors sectors;
    scalar best = 0;

    for (unsigned bits = 3; bits < (1u << candidates_.size()); ++bits)
    {
        // Not with one bit only
        if ((bits & (bits - 1)) && isSymmetric(bits))
        {
            consider(bits, best, sectors);
        }
    }

    const labelList& starts = sectors.starts;
    sectors.planes.setSize(starts.size());
    forAll(starts, s)
    {
        sectors.planes[s] = planesOf(starts[s], starts.fcValue(s));
    }

    return side_ && starts.size() ? half(sectors) : sectors;
}

} // End namespace Foam

// ************************************************************************* //
