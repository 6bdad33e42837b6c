/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceSectors.H"
#include "DynamicField.H"
#include "mathematicalConstants.H"
#include "normalSectors.H"
#include "sectorSearch.H"
#include "stageProgress.H"

namespace Foam
{

namespace
{

//- Directions near the edges around a point
struct nearEdges
{
    const facesAround& around;
    const vectorField& neighbourDirections;
    const bitSet& shared;


    static vector across(const vector& e, const vector& x)
    {
        return normalised(x - (x & e)*e);
    }


    //- From 0 to 2 pi: about edge i from face i to x
    scalar angleAbout(const label i, const vector& x) const
    {
        const vector& e = around.edges[i];
        const vector ahead = across(e, around.edges[around.next(i)]);
        const scalar angle = ::atan2((e ^ ahead) & x, ahead & x);

        return angle < 0 ? angle + constant::mathematical::twoPi : angle;
    }


    //- In the plane of the side patch, at a distance from its edge of face i or
    //  further away: from the other one at less than 180 degrees
    vector nearBorder(const label i, const scalar distance) const
    {
        const vectorField& edges = around.edges;
        const vector& e = around.isFirst(i) ? edges.first() : edges.last();
        const vector& other = around.isFirst(i) ? edges.last() : edges.first();

        vector inPlane(normalised(around.side->normal ^ e));
        inPlane *= (inPlane & around.normals[i].last()) < 0 ? -1 : 1;

        const scalar pi = constant::mathematical::pi;
        const scalar toOther = ::atan2(other & inPlane, other & e);
        const scalar all = toOther < 0 ? toOther + 2*pi : toOther;
        const scalar angle =
            max(distance, 0.5*(all - frontControls::largestAngle*pi));

        return ::cos(angle)*e + ::sin(angle)*inPlane;
    }


    //- At a distance from the first or second edge of face i. The direction of
    //  the face on the other side is near to another edge: about this one it
    //  is at less than 180 degrees, and the direction of the neighbour is
    //  between both.
    vector nearEdge
    (
        const label i,
        const bool isFirstEdge,
        const scalar distance
    ) const
    {
        const label j = isFirstEdge ? i : around.next(i);
        const scalar pi = constant::mathematical::pi;
        const scalar all = angleAbout(j, around.edges[around.prev(j)]);
        const scalar neighbourAngle = angleAbout(j, neighbourDirections[j]);

        const scalar right = shared.test(j) ? pi/2 : GREAT;
        const scalar low =
            isFirstEdge
          ? max(scalar(0), neighbourAngle - right) : neighbourAngle;
        const scalar high =
            isFirstEdge ? neighbourAngle : min(all, neighbourAngle + right);
        const scalar angle = 0.5*(max(low, all - pi) + min(high, pi));

        const vector& e = around.edges[j];
        const vector ahead = across(e, around.edges[around.next(j)]);

        return normalised
        (
            e + distance*(::cos(angle)*ahead + ::sin(angle)*(e ^ ahead))
        );
    }


    //- Around a point of a border the edge at which no direction is, that with
    //  the smallest angle; else none
    label edgeWithout() const
    {
        label without = around.edges.size();
        scalar smallest = GREAT;

        for (label j = 1; around.side && j < around.normals.size(); ++j)
        {
            const scalar angle = angleAbout(j, around.edges[around.prev(j)]);
            if (angle < smallest)
            {
                smallest = angle;
                without = j;
            }
        }

        return without;
    }
};

} // End anonymous namespace


//- Returns a direction for each face around a point, near to the edge at which
//  the face begins. Each direction is on its face's side of the column at the
//  other end of the edge. Around a point of a border the directions of the
//  first and the last face are in the plane of the side patch, and no direction
//  is near to the edge with the smallest angle: faces after this edge have
//  their directions near to the edges at which they end.
//  neighbourDirections: directions of the columns at the other ends of edges
//  shared: edges at whose other ends sectors meet, too. A direction near to
//  such an edge is within a right angle of the neighbour's, about the edge.
//  distance: of a direction from its edge, on the unit sphere
static vectorField directionsNearEdges
(
    const facesAround& around,
    const vectorField& neighbourDirections,
    const bitSet& shared,
    const scalar distance
)
{
    const nearEdges edges{around, neighbourDirections, shared};
    const label without = edges.edgeWithout();
    vectorField d(around.normals.size());
    forAll(d, i)
    {
        d[i] = around.isFirst(i) || around.isLast(i)
          ? edges.nearBorder(i, distance)
          : edges.nearEdge(i, i < without, distance);
    }

    return d;
}


// * * * * * * * * * * * * * * *  Face Sectors * * * * * * * * * * * * * * * //

namespace
{

//- Directions for all faces around a point
struct faceDirections
{
    const facesAround& around;

    //- Directions of the columns at the other ends of the edges
    const vectorField& neighbourDirections;

    //- Edges at whose other ends sectors meet too
    const bitSet& shared;

    vectorField d = vectorField(around.normals.size());

    faceList triangles{};


    //- Within a right angle of the direction of the neighbour, about edge j
    void appendShared(const label j, DynamicField<vector>& all) const
    {
        if (shared.test(j))
        {
            const vector& e = around.edges[j];
            const vector& x = neighbourDirections[j];
            all.append(normalised(x - (x & e)*e));
        }
    }


    //- What direction i must be in front of so that the directions of the
    //  neighbours at its edges are on the other sides, and all triangles
    //  positive
    vectorField limits(const label i) const
    {
        DynamicField<vector> all(around.normals[i]);

        if (!around.isFirst(i))
        {
            const vector& e = around.edges[i];
            all.append(normalised(neighbourDirections[i] ^ e));
            all.append(normalised(d.rcValue(i) ^ e));
            appendShared(i, all);
        }
        if (!around.isLast(i))
        {
            const vector& e = around.edges[around.next(i)];
            all.append(normalised(e ^ neighbourDirections[around.next(i)]));
            all.append(normalised(e ^ d.fcValue(i)));
            appendShared(around.next(i), all);
        }

        for (const face& t : triangles)
        {
            const label k = t.find(i);
            if (k >= 0)
            {
                all.append(normalised(d[t.nextLabel(k)] ^ d[t.prevLabel(k)]));
            }
        }

        if (around.isFirst(i) || around.isLast(i))
        {
            for (label k = all.size() - 1; k >= 0; --k)
            {
                all.append(around.side->reflected(all[k]));
            }
        }

        return vectorField(std::move(all));
    }


    bool isPositive() const
    {
        bool positive = true;
        forAll(d, i)
        {
            positive = positive && min(limits(i) & d[i]) > 0;
        }

        return positive;
    }


    //- Whether triangles surround each direction once; in the plane of a side
    //  patch, half of it
    bool closes() const
    {
        scalarField angles(d.size(), 0);
        forAll(d, i)
        {
            const vector& e = around.edges[i];
            const vector& f = around.edges[around.next(i)];

            angles[i] =
                (around.isFirst(i) ? 0 : angleAt(d[i], d.rcValue(i), e))
              + angleAt(d[i], e, f)
              + (around.isLast(i) ? 0 : angleAt(d[i], f, d.fcValue(i)))
              - (around.isFirst(i) || around.isLast(i) ? 1 : 2)
               *constant::mathematical::pi;
        }

        addAngles(d, triangles, angles);

        return max(mag(angles)) < frontControls::angleTolerance;
    }


    //- Put all directions near edges
    bool begin(const scalar distance)
    {
        d = directionsNearEdges(around, neighbourDirections, shared, distance);

        return cutIntoTriangles(d, triangles) && closes();
    }


    //- Put each direction into the axis of its cone, until they agree. True if
    //  all are in front of their limits then.
    bool centre()
    {
        const auto centreAll = [&]()
        {
            bool changed = false;
            forAll(d, i)
            {
                const visibilityCone cone(makeVisibilityCone(limits(i)));

                if (!cone.empty())
                {
                    changed = changed || d[i] != cone.axis;
                    d[i] = cone.axis;
                }
            }

            return changed;
        };
        repeatUntilStable
        (
            "centring directions", frontControls::maxRounds, centreAll
        );

        return isPositive();
    }


    //- The sectors; none where not even directions very near to the edges fit
    normalSectors sectors()
    {
        normalSectors all;
        scalar distance = frontControls::ringDistance;
        bool fits = false;
        for (label k = 0; !fits && k < frontControls::maxRings; ++k)
        {
            fits = begin(distance) && centre();
            distance *= 0.5;
        }

        if (!fits)
        {
            return all;
        }

        all.starts = identity(d.size());
        all.axes = d;
        all.triangles = triangles;
        forAll(d, i)
        {
            all.planes.append(limits(i));
        }

        return all;
    }
};

} // End anonymous namespace


normalSectors makeFaceSectors
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const vectorField& neighbourDirections,
    const bitSet& shared,
    const label p
)
{
    const facesAround around(wall, addressing, visibility, p);

    // On two side patches a column can only stand on the line of both
    return addressing.sidesOf(p).size() > 1 || around.normals.size() < 2
      ? normalSectors()
      : faceDirections{around, neighbourDirections, shared}.sectors();
}

} // End namespace Foam

// ************************************************************************* //
