/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "windingNumber.H"

#include <algorithm>
#include <random>

namespace Foam
{

typedef exactKernel::Point_3 point3;
typedef exactKernel::Triangle_3 triangle3;
typedef exactKernel::Vector_3 vector3;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool windingNumber::along
(
    const vector3& direction,
    const face& part,
    const label triangle,
    label& number
) const
{
    const triangle3 p = divided_.triangleOn(part);
    const point3 begin = CGAL::centroid(p[0], p[1], p[2]);
    const point3 end = begin + direction;
    const std::vector<label>& inPlane = divided_.inPlane[triangle];
    const point from = rounded(begin);
    const point to = from + 2*size_*normalised(rounded(end) - from);
    point hit;
    number = 0;

    forAll(triangles_, i)
    {
        if
        (
            i == triangle || !boxes_[i].intersects(from, to, hit)
         || std::binary_search(inPlane.begin(), inPlane.end(), i)
        )
        {
            continue;
        }

        const triangle3 t = divided_.triangleOn(triangles_[i]);
        label nSides[3] = {0, 0, 0};
        for (int k = 0; k < 3; ++k)
        {
            ++nSides[1 + CGAL::orientation(begin, end, t[k], t[k + 1])];
        }
        if (nSides[0] && nSides[2])
        {
            continue;
        }

        const vector3 n = CGAL::normal(t[0], t[1], t[2]);
        const int along = CGAL::sign(n*direction);
        const int side = CGAL::orientation(t[0], t[1], t[2], begin);
        if (side == 0 || along == side)
        {
            continue;
        }
        if (nSides[1] || along == 0)
        {
            // Through an edge of the triangle, or within its plane
            return false;
        }
        number += along;
    }

    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

windingNumber::windingNumber
(
    const wallSurface& surface,
    const dividedTriangles& divided
)
:
    triangles_(surface.faces),
    divided_(divided),
    size_(boundBox(surface.points, false).mag())
{
    boxes_.reserve(triangles_.size());
    for (const face& f : triangles_)
    {
        treeBoundBox box(surface.points, f);
        box.min() -= vector::uniform(1e-9*size_);
        box.max() += vector::uniform(1e-9*size_);
        boxes_.push_back(box);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label windingNumber::inFront(const face& part, const label triangle) const
{
    const triangle3 p = divided_.triangleOn(part);
    const vector3 n = CGAL::normal(p[0], p[1], p[2]);
    const vector normal =
        normalised(rounded(CGAL::ORIGIN + n) - point::zero);

    std::mt19937 random(triangle);
    std::uniform_real_distribution<scalar> share(-0.3, 0.3);
    label number = 0;

    for (;;)
    {
        const vector3 direction
        (
            normal.x() + share(random), normal.y() + share(random),
            normal.z() + share(random)
        );
        if (n*direction > 0 && along(direction, part, triangle, number))
        {
            return number;
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
