/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "DynamicList.H"
#include "FixedList.H"
#include "labelVector.H"
#include "mathematicalConstants.H"
#include "Map.H"
#include "Random.H"

#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace testSurfaces
{

//- Boxes between the planes x, y and z = the given coordinates, those that are
//  filled
class boxes
{
    const FixedList<scalarList, 3> planes_;
    const std::function<bool(const labelVector&)> filled_;

    Map<label> pointOf_;
    DynamicList<point> points_;
    DynamicList<face> faces_;


    label nBoxes(const direction d) const
    {
        return planes_[d].size() - 1;
    }

    bool isFilled(const labelVector& v) const
    {
        for (direction d = 0; d < 3; ++d)
        {
            if (v[d] < 0 || v[d] >= nBoxes(d))
            {
                return false;
            }
        }

        return filled_(v);
    }

    label pointLabel(const labelVector& v)
    {
        const label key =
            (v.x()*planes_[1].size() + v.y())*planes_[2].size() + v.z();

        if (pointOf_.insert(key, points_.size()))
        {
            points_.append
            (
                point(planes_[0][v.x()], planes_[1][v.y()], planes_[2][v.z()])
            );
        }

        return pointOf_[key];
    }

    //- Those of the box's sides behind which nothing is filled
    void addSides(const labelVector& v)
    {
        for (label side = 0; side < 6; ++side)
        {
            const direction d = side/2;
            labelVector a(v), beyond(v), u(0, 0, 0), w(0, 0, 0);
            beyond[d] += side % 2 ? 1 : -1;
            a[d] += side % 2;
            u[(d + 2 - side % 2) % 3] = 1;
            w[(d + 1 + side % 2) % 3] = 1;

            if (!isFilled(beyond))
            {
                faces_.append
                (
                    face
                    ({
                        pointLabel(a), pointLabel(a + u),
                        pointLabel(a + u + w), pointLabel(a + w)
                    })
                );
            }
        }
    }

public:

    boxes
    (
        const FixedList<scalarList, 3>& planes,
        const std::function<bool(const labelVector&)>& filled
    )
    :
        planes_(planes),
        filled_(filled)
    {
        for (label x = 0; x < nBoxes(0); ++x)
        {
            for (label y = 0; y < nBoxes(1); ++y)
            {
                for (label z = 0; z < nBoxes(2); ++z)
                {
                    if (filled_(labelVector(x, y, z)))
                    {
                        addSides(labelVector(x, y, z));
                    }
                }
            }
        }
    }

    wallSurface surface()
    {
        wallSurface wall;
        wall.points.transfer(points_);
        wall.faces.transfer(faces_);
        wall.patchIDs.setSize(wall.faces.size(), 0);
        wall.patchNames = wordList(1, word("wall"));

        return wall;
    }
};

} // End namespace testSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::testSurfaces::cubesAbout
(
    const point& centre,
    const unsigned filled
)
{
    FixedList<scalarList, 3> planes;
    for (direction d = 0; d < 3; ++d)
    {
        planes[d] = scalarList({centre[d] - 1, centre[d], centre[d] + 1});
    }

    return boxes
    (
        planes,
        [=](const labelVector& v)
        {
            return filled & (1u << (4*v.x() + 2*v.y() + v.z()));
        }
    ).surface();
}


Foam::wallSurface Foam::testSurfaces::screw(const point& centre)
{
    // (0 0 0), (1 0 0), (1 1 0), (1 1 1)
    return cubesAbout(centre, 1u << 0 | 1u << 4 | 1u << 6 | 1u << 7);
}


Foam::wallSurface Foam::testSurfaces::bladeOnEdge(const scalar thickness)
{
    FixedList<scalarList, 3> planes;
    planes[0] = scalarList({-1, 0, thickness, 1});
    planes[1] = scalarList({-1, 0, 1});
    planes[2] = scalarList({-1, 0, 1});

    return boxes
    (
        planes,
        [](const labelVector& v)
        {
            return v.z() ? v.x() == 1 : v.y() == 0;
        }
    ).surface();
}


Foam::wallSurface Foam::testSurfaces::fan(const vectorField& directions)
{
    const label n = directions.size();

    wallSurface wall;
    wall.points = pointField(1, point(Zero));
    wall.points.append(directions);
    wall.points.append(point(0, 0, -3));
    wall.faces.setSize(2*n);
    wall.patchIDs.setSize(2*n, 0);
    wall.patchNames = wordList(1, word("wall"));

    for (label i = 0; i < n; ++i)
    {
        const label a = i + 1;
        const label b = (i + 1) % n + 1;

        wall.faces[i] = face({0, a, b});
        wall.faces[n + i] = face({n + 1, b, a});
    }

    return wall;
}


Foam::vectorField Foam::testSurfaces::tennisBallSeam
(
    const label n,
    const scalar b,
    const scalar jitter,
    Random& random
)
{
    using constant::mathematical::twoPi;

    vectorField directions(n);

    forAll(directions, i)
    {
        const scalar t =
            twoPi*(i + jitter*random.position<scalar>(-0.5, 0.5))/n;

        directions[i] = vector
        (
            (1 - b)*Foam::cos(t) + b*Foam::cos(3*t),
            (1 - b)*Foam::sin(t) - b*Foam::sin(3*t),
            2*Foam::sqrt(b*(1 - b))*Foam::sin(2*t)
        );
    }

    return directions;
}


// ************************************************************************* //
