/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "chamfers.H"
#include "EdgeMap.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Planes meet if the volume of their normals, or its like for two of them, is
//  larger
static constexpr scalar leastVolume = 0.1;

//- They meet near a sharp line if it is within this share of the reach
static constexpr scalar meetingShare = 0.25;


namespace
{

struct chamferSplitter
{
    const tangentPlanes& planes;
    const sharpLines& lines;
    wallSurface& wrap;

    //- Labels of the points of edges, after those of the wrap
    EdgeMap<label> onEdges{};

    DynamicList<point> middles{};
    DynamicList<point> targets{};


    //- Add a point that is to go to where the planes of others meet; -1 if they
    //  do not
    label add(const UList<label>& p, const point& middle, const scalar reach)
    {
        const pointIndexHit hit(planes.meet(p, middle, lines, reach));
        if (!hit.hit())
        {
            return -1;
        }

        middles.append(middle);
        targets.append(hit.rawPoint());

        return wrap.points.size() + middles.size() - 1;
    }


    label addCorner(const face& f)
    {
        scalar longest = 0;
        for (const edge& e : f.edges())
        {
            if (!planes.areAcross(e.start(), e.end()))
            {
                return -1;
            }
            longest = max(longest, e.mag(wrap.points));
        }

        return add(f, f.centre(wrap.points), longest);
    }


    //- Between points of the wrap and new ones, where these are yet
    scalar distance(const label p, const label q) const
    {
        const label n = wrap.points.size();
        const auto at = [&](const label r)
        {
            return r < n ? wrap.points[r] : middles[r - n];
        };

        return mag(at(p) - at(q));
    }


    //- The triangle with the points on its edges
    face withMiddles(const face& f) const
    {
        face all;

        forAll(f, k)
        {
            const auto middle = onEdges.cfind(f.faceEdge(k));
            all.append(f[k]);
            if (middle.found())
            {
                all.append(middle.val());
            }
        }

        return all;
    }


    //- Append the parts of a triangle
    void split(const face& f, DynamicList<face>& parts)
    {
        const face all(withMiddles(f));
        const label nOld = wrap.points.size();
        const label n = all.size();

        const label centre = addCorner(f);

        if (centre >= 0)
        {
            forAll(all, k)
            {
                parts.append(face({all[k], all.nextLabel(k), centre}));
            }
        }
        else if (n == 6)
        {
            const label k = all[0] < nOld ? 1 : 0;
            parts.append(face({all[k], all[k + 2], all[k + 4]}));
            for (label i = k; i < n; i += 2)
            {
                const label next = all[(i + 2) % n];
                parts.append(face({all[i], all[(i + 1) % n], next}));
            }
        }
        else if (n > 3)
        {
            // From a new point; of two, by the shorter diagonal
            const auto at = [&](const label k) { return all[k % n]; };
            label k = 0;
            while (at(k) < nOld || at(k + 1) >= nOld || at(k + 2) >= nOld)
            {
                ++k;
            }
            if (n == 5 && distance(at(k), at(k + 2))
              > distance(at(k + 1), at(k + 3)))
            {
                k += 3;
            }

            for (label i = 1; i + 1 < n; ++i)
            {
                parts.append(face({at(k), at(k + i), at(k + i + 1)}));
            }
        }
        else
        {
            parts.append(f);
        }
    }


    pointField split(const edgeList& across)
    {
        for (const edge& e : across)
        {
            const label p =
                add(labelList(e), e.centre(wrap.points), e.mag(wrap.points));
            if (p >= 0)
            {
                onEdges.insert(e, p);
            }
        }

        DynamicList<face> faces(wrap.faces.size());
        DynamicList<label> patchIDs(wrap.faces.size());
        forAll(wrap.faces, facei)
        {
            split(wrap.faces[facei], faces);
            patchIDs.setSize(faces.size(), wrap.patchIDs[facei]);
        }

        wrap.faces.transfer(faces);
        wrap.patchIDs.transfer(patchIDs);
        wrap.points.append(middles);

        return pointField(std::move(targets));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

pointIndexHit tangentPlanes::meet
(
    const UList<label>& p,
    const point& beside,
    const sharpLines& lines,
    const scalar reach
) const
{
    const auto behind = [&](const label i)
    {
        return normals[p[i]] & (points[p[i]] - beside);
    };

    const vector& m = normals[p[0]];
    const vector& n = normals[p[1]];
    scalar det;
    vector toAll;

    if (p.size() == 2)
    {
        const scalar a = behind(0);
        const scalar b = behind(1);
        det = 1 - sqr(m & n);
        toAll = (a - (m & n)*b)*m + (b - (m & n)*a)*n;
    }
    else
    {
        const vector& l = normals[p[2]];
        det = l & (m ^ n);
        toAll = behind(0)*(n ^ l) + behind(1)*(l ^ m) + behind(2)*(m ^ n);
    }

    if (mag(det) < leastVolume || mag(toAll) > reach*mag(det))
    {
        return pointIndexHit();
    }

    const point meeting(beside + toAll/det);
    pointIndexHit hit(lines.findNearest(meeting, meetingShare*reach));

    bool isOff = false;
    bool isOnSide = false;
    bool isBetween = false;
    forAll(p, i)
    {
        isOff = isOff || areOff.test(p[i]);
        isOnSide = isOnSide || onSides.test(p[i]);
        isBetween = isBetween || (hit.hit() && lines.isBetween
        (
            hit.index(), normals[p[i]], normals[p.fcValue(i)]
        ));
    }

    if (isOff)
    {
        hit.rawPoint() = meeting;
    }

    return isBetween || isOnSide || isOff ? hit : pointIndexHit();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

pointField splitChamfers
(
    const tangentPlanes& planes,
    const sharpLines& lines,
    const edgeList& across,
    wallSurface& wrap
)
{
    return chamferSplitter{planes, lines, wrap}.split(across);
}

} // End namespace Foam

// ************************************************************************* //
