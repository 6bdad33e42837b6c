/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "directionsNearEdges.H"
#include "mathematicalConstants.H"
#include "normalSectors.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

vectorField directionsNearEdges
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

} // End namespace Foam

// ************************************************************************* //
