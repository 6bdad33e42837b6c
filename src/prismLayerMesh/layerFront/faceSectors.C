/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceSectors.H"
#include "directionTriangles.H"
#include "DynamicField.H"
#include "facesAround.H"
#include "mathematicalConstants.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Directions for all faces around a point
class faceDirections
{
    const facesAround around_;

    //- Directions of the columns at the other ends of the edges
    const vectorField& middles_;

    vectorField d_;

    faceList triangles_;


    static vector across(const vector& e, const vector& x)
    {
        return normalised(x - (x & e)*e);
    }


    //- From 0 to 2 pi: about edge i from face i to x
    scalar angleAbout(const label i, const vector& x) const
    {
        const vector& e = around_.edges[i];
        const vector ahead = across(e, around_.edges.fcValue(i));
        const scalar angle = ::atan2((e ^ ahead) & x, ahead & x);

        return angle < 0 ? angle + constant::mathematical::twoPi : angle;
    }


    //- At a distance from edge i; seen from there neither the middle nor the
    //  direction of the face before is at more than 180 degrees
    vector nearEdge(const label i, const scalar distance) const
    {
        const scalar pi = constant::mathematical::pi;
        const scalar least = angleAbout(i, around_.edges.rcValue(i)) - pi;
        const scalar most = min(angleAbout(i, middles_[i]), pi);

        const scalar angle = 0.5*(max(least, scalar(0)) + most);
        const vector& e = around_.edges[i];
        const vector ahead = across(e, around_.edges.fcValue(i));

        return normalised
        (
            e + distance*(::cos(angle)*ahead + ::sin(angle)*(e ^ ahead))
        );
    }


    //- What direction i must be in front of so that the middles at its edges
    //  are on the other sides, and all triangles positive
    vectorField limits(const label i) const
    {
        const label next = d_.fcIndex(i);
        const vector& e = around_.edges[i];
        const vector& f = around_.edges[next];

        DynamicField<vector> all(around_.normals[i]);
        all.append(normalised(middles_[i] ^ e));
        all.append(normalised(d_.rcValue(i) ^ e));
        all.append(normalised(f ^ middles_[next]));
        all.append(normalised(f ^ d_[next]));

        for (const face& t : triangles_)
        {
            const label k = t.find(i);
            if (k >= 0)
            {
                all.append(normalised(d_[t.nextLabel(k)] ^ d_[t.prevLabel(k)]));
            }
        }

        return vectorField(std::move(all));
    }


    bool isPositive() const
    {
        bool positive = true;
        forAll(d_, i)
        {
            positive = positive && min(limits(i) & d_[i]) > 0;
        }

        return positive;
    }


    //- Put all directions near their edges
    bool begin(const scalar distance)
    {
        forAll(d_, i)
        {
            d_[i] = nearEdge(i, distance);
        }

        return cutIntoTriangles(d_, triangles_)
            && isPositive()
            && closeAround(identity(d_.size()), around_.edges, d_, triangles_);
    }


    //- Put each direction into the axis of its cone
    void centre()
    {
        forAll(d_, i)
        {
            const visibilityCone cone(makeVisibilityCone(limits(i)));

            if (!cone.empty())
            {
                d_[i] = cone.axis;
            }
        }
    }


public:

    faceDirections
    (
        const facesAround& around,
        const vectorField& middles
    )
    :
        around_(around),
        middles_(middles),
        d_(middles.size())
    {}


    //- The sectors; none where not even directions very near to the edges fit
    normalSectors sectors()
    {
        scalar distance = frontControls::ringDistance;
        bool begun = begin(distance);
        for (label k = 1; !begun && k < frontControls::maxRings; ++k)
        {
            distance *= 0.5;
            begun = begin(distance);
        }

        normalSectors all;
        if (!begun)
        {
            return all;
        }

        for (label round = 0; round < frontControls::maxRounds; ++round)
        {
            centre();
        }

        all.starts = identity(d_.size());
        all.axes = d_;
        all.triangles = triangles_;
        forAll(d_, i)
        {
            all.planes.append(limits(i));
        }

        return all;
    }
};

} // End anonymous namespace

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

normalSectors makeFaceSectors
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const vectorField& middles,
    const label p
)
{
    return addressing.isOnBorder(p)
      ? normalSectors()
      : faceDirections
        (
            facesAround(wall, addressing, visibility, p), middles
        ).sectors();
}

} // End namespace Foam

// ************************************************************************* //
