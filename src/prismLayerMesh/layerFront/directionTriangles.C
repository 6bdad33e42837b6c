/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "directionTriangles.H"
#include "normalSectors.H"
#include "DynamicList.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
        && std::none_of(polygon.begin(), polygon.end(), holds);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

} // End namespace Foam

// ************************************************************************* //
