/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sectorSearch.H"
#include "DynamicField.H"
#include "DynamicList.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include "normalSectors.H"
#include "ranges.H"

namespace Foam
{

static scalar volume(const vector& a, const vector& b, const vector& c)
{
    return (a ^ b) & c;
}


//- Whether the triangle of corner k of a polygon of unit vectors is positive
//  and holds no other corner
static bool isEar
(
    const vectorField& d,
    const UList<label>& polygon,
    const label k
)
{
    const label prev = polygon[polygon.rcIndex(k)];
    const label next = polygon[polygon.fcIndex(k)];
    const label cur = polygon[k];

    const auto holds = [&](const label x)
    {
        return x != prev && x != cur && x != next
            && volume(d[prev], d[cur], d[x]) > 0
            && volume(d[cur], d[next], d[x]) > 0
            && volume(d[next], d[prev], d[x]) > 0;
    };

    return volume(d[prev], d[cur], d[next]) >= frontControls::smallestVolume
        && !anyOf(polygon, holds);
}


scalar angleAt(const vector& d, const vector& a, const vector& b)
{
    return ::atan2(mag(d & (a ^ b)), (a & b) - (a & d)*(b & d));
}


void addAngles
(
    const vectorField& d,
    const faceList& triangles,
    scalarField& angles
)
{
    for (const face& t : triangles)
    {
        forAll(t, k)
        {
            angles[t[k]] +=
                angleAt(d[t[k]], d[t.nextLabel(k)], d[t.prevLabel(k)]);
        }
    }
}


bool cutIntoTriangles(const vectorField& d, faceList& triangles)
{
    DynamicList<label> left(identity(d.size()));
    DynamicList<face> cut;

    while (left.size() > 2)
    {
        label k = 0;
        while (k < left.size() && !isEar(d, left, k))
        {
            ++k;
        }

        if (k == left.size())
        {
            return false;
        }

        cut.append
        (
            face({left[left.rcIndex(k)], left[k], left[left.fcIndex(k)]})
        );
        left.remove(k);
    }

    triangles = faceList(std::move(cut));

    return true;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void sectorSearch::setPlanes(const label i, const vector& toNeighbour)
{
    const vector& e = edges_[i];

    planes_[i].first() = normalised(toNeighbour ^ e);
    planes_[i].second() = normalised(toNeighbour - (toNeighbour & e)*e);
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
        visibility.cones[p].isFlat()
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

    const scalar score = narrowest/::pow(1 + frontControls::sectorGain, n - 2);
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
