/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "normalSectors.H"
#include "DynamicField.H"
#include "mathematicalConstants.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static scalar volume(const vector& a, const vector& b, const vector& c)
{
    return (a ^ b) & c;
}


//- Angle at d of the spherical triangle from d to a and b
static scalar angleAt(const vector& d, const vector& a, const vector& b)
{
    return ::atan2(mag(d & (a ^ b)), (a & b) - (a & d)*(b & d));
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
        && std::none_of(polygon.begin(), polygon.end(), holds);
}


//- Cut a polygon of unit vectors into positive triangles; false if there are
//  none
static bool cutIntoTriangles(const vectorField& d, faceList& triangles)
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


namespace
{

//- All divisions of the faces around one point
class sectorSearch
{
    const wallVisibility& visibility_;
    const label p_;

    //- Cosine of the narrowest cone of a division
    const scalar least_;

    //- Unit vectors along the edges, edge i before face i
    vectorField edges_;

    //- What a column sees: the normals of each face
    List<vectorField> normals_;

    //- At each edge: the sides of the planes that the sector that begins there
    //  must be on. The one that ends there is on the other side of the first.
    List<Pair<vector>> planes_;

    //- Edges where sectors may meet, in ascending order
    labelList candidates_;

    //- Cones of the sectors from one candidate to another
    List<List<visibilityCone>> cones_;


    void setPlanes(const label i, const vector& middle)
    {
        const vector& e = edges_[i];

        planes_[i].first() = normalised(middle ^ e);
        planes_[i].second() = normalised(middle - (middle & e)*e);
    }


    void setCandidates()
    {
        const vectorField& corners = visibility_.cornerNormals[p_];
        scalarField cosines(edges_.size());
        forAll(cosines, i)
        {
            cosines[i] = corners[i] & corners[corners.rcIndex(i)];
        }

        candidates_ = sortedOrder(cosines);
        candidates_.setSize(min(candidates_.size(), frontControls::maxEdges));
        sort(candidates_);
    }


    vectorField planesOf(const label first, const label last) const
    {
        return vectorField
        ({
            planes_[first].first(), planes_[first].second(),
            -planes_[last].first(), planes_[last].second()
        });
    }


    //- Of the sector between two edges
    visibilityCone cone(const label first, const label last) const
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


    //- Whether the triangles close around each direction, once
    bool closes
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

        for (const face& t : triangles)
        {
            forAll(t, k)
            {
                angles[t[k]] +=
                    angleAt(d[t[k]], d[t.nextLabel(k)], d[t.prevLabel(k)]);
            }
        }

        return max(mag(angles - constant::mathematical::twoPi))
          < frontControls::angleTolerance;
    }


    //- The division at the edges whose bits are set, where its narrowest cone
    //  is wider than best, which then is raised
    void consider(const unsigned bits, scalar& best, normalSectors& sectors)
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
         && cutIntoTriangles(axes, triangles)
         && closes(starts, axes, triangles)
        )
        {
            best = score;
            sectors.starts = starts;
            sectors.axes = axes;
            sectors.triangles = triangles;
        }
    }


public:

    sectorSearch
    (
        const wallSurface& wall,
        const wallAddressing& addressing,
        const wallVisibility& visibility,
        const vectorField& middles,
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
        ),
        edges_(addressing.pointPoints[p].size()),
        normals_(edges_.size()),
        planes_(edges_.size())
    {
        forAll(edges_, i)
        {
            const label q = addressing.pointPoints[p][i];
            edges_[i] = normalised(wall.points[q] - wall.points[p]);

            normals_[i] =
                polygonNormals(wall, addressing.pointFaces[p][i], p);
            normals_[i].append(visibility_.cornerNormals[p][i]);
            setPlanes(i, middles[i]);
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


    normalSectors best()
    {
        normalSectors sectors;
        scalar best = 0;

        for (unsigned bits = 3; bits < (1u << candidates_.size()); ++bits)
        {
            // Not with one bit only
            if (bits & (bits - 1))
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

        return sectors;
    }
};

} // End anonymous namespace

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
    const vectorField& middles,
    const label p
)
{
    return sectorSearch(wall, addressing, visibility, middles, p).best();
}

} // End namespace Foam

// ************************************************************************* //
