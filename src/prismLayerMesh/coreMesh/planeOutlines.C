/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planeOutlines.H"
#include "sidePatch.H"
#include "surfaceMeasures.H"

#include <cmath>
#include <vector>

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void planeOutlines::set(List<edgeList>& borders, List<edgeList>& limits) const
{
    borders.setSize(gone_.size());
    limits.setSize(gone_.size());

    forAll(gone_, s)
    {
        for (const edge& e : outline(gone_[s]))
        {
            if (stayingEdges_.found(e))
            {
                borders[s].append(e);
            }
            else if (!wallEdges_.found(e))
            {
                limits[s].append(e);
            }
        }
    }
}


// * * * * * * * * * * * * * * *  Split Polygon  * * * * * * * * * * * * * * //

//- 1 of an equilateral triangle, 0 of one without area; negative if its normal
//  is opposite to a given one
static scalar shape
(
    const point& a,
    const point& b,
    const point& c,
    const vector& normal
)
{
    const scalar edges = magSqr(b - a) + magSqr(c - b) + magSqr(a - c);

    return 2*std::sqrt(scalar(3))*(((b - a) ^ (c - a)) & normal)
        /(edges + VSMALL);
}


faceList splitPolygon(const pointField& points, const face& polygon)
{
    const label n = polygon.size();
    const vector normal(normalised(polygon.areaNormal(points)));
    const auto at = [&](const label i) -> const point&
    {
        return points[polygon[i]];
    };

    // The worst triangle of the best split of the part from point i to j > i,
    // and the third point of the triangle on the edge ij
    std::vector<scalar> worst(n*n, 1);
    std::vector<label> third(n*n, -1);

    for (label span = 2; span < n; ++span)
    {
        for (label i = 0, j = span; j < n; ++i, ++j)
        {
            worst[i*n + j] = -GREAT;
            for (label k = i + 1; k < j; ++k)
            {
                const scalar least = min
                (
                    shape(at(i), at(k), at(j), normal),
                    min(worst[i*n + k], worst[k*n + j])
                );
                if (least > worst[i*n + j])
                {
                    worst[i*n + j] = least;
                    third[i*n + j] = k;
                }
            }
        }
    }

    DynamicList<face> triangles(n);
    DynamicList<labelPair> parts;
    parts.append(labelPair(0, n - 1));
    while (parts.size())
    {
        const labelPair part(parts.remove());
        const label i = part.first(), j = part.second();
        const label k = third[i*n + j];
        if (k >= 0)
        {
            triangles.append(face({polygon[i], polygon[k], polygon[j]}));
            parts.append(labelPair(i, k));
            parts.append(labelPair(k, j));
        }
    }

    return faceList(std::move(triangles));
}

} // End namespace Foam

// ************************************************************************* //
