/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "convexHull.H"
#include "cellPredicates.H"
#include "DynamicList.H"

#include <set>
#include <utility>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

static face triangle(const label a, const label b, const label c)
{
    face f(3);
    f[0] = a;
    f[1] = b;
    f[2] = c;

    return f;
}


//- Whether x is outside of the plane of f
static bool sees(const point& x, const face& f, const pointField& points)
{
    return orientation(points[f[0]], points[f[1]], points[f[2]], x) > 0;
}


//- The tetrahedron on the first four points
static DynamicList<face> firstHull(const pointField& points)
{
    DynamicList<face> hull;

    for (label i = 0; i < 4; ++i)
    {
        face f(triangle((i + 1) % 4, (i + 2) % 4, (i + 3) % 4));

        if (sees(points[i], f, points))
        {
            f.flip();
        }

        hull.append(f);
    }

    return hull;
}


//- Replace what x sees by the cone from x to the rim of that
static void addPoint
(
    DynamicList<face>& hull,
    const label x,
    const pointField& points
)
{
    std::set<std::pair<label, label>> sides;
    DynamicList<face> kept(hull.size());

    for (const face& f : hull)
    {
        if (!sees(points[x], f, points))
        {
            kept.append(f);
            continue;
        }

        forAll(f, i)
        {
            sides.insert({f[i], f.nextLabel(i)});
        }
    }

    for (const auto& side : sides)
    {
        if (!sides.count({side.second, side.first}))
        {
            kept.append(triangle(side.first, side.second, x));
        }
    }

    hull.transfer(kept);
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::faceList Foam::randomSurfaces::convexHull(const pointField& points)
{
    DynamicList<face> hull(firstHull(points));

    for (label x = 4; x < points.size(); ++x)
    {
        addPoint(hull, x, points);
    }

    return faceList(std::move(hull));
}


// ************************************************************************* //
