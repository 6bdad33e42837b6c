/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frontTets.H"
#include "backgroundMesh.H"
#include "triangleIndex.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Triangles, and the points that have any
class frontTriangles
{
    const triangleIndex index_;
    boolList hasTriangle_;

public:

    frontTriangles(const faceList& triangles, const label nPoints)
    :
        index_(makeTriangleIndex(triangles)),
        hasTriangle_(nPoints, false)
    {
        for (const face& f : triangles)
        {
            UIndirectList<bool>(hasTriangle_, f) = true;
        }
    }

    //- The triangle of a face, -1 if it is none
    label find(const triFace& f) const
    {
        return hasTriangle_[f[0]] && hasTriangle_[f[1]] && hasTriangle_[f[2]]
          ? index_.lookup(f, -1) : -1;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

boolList isOnFront
(
    const pointField& points,
    const tetCellList& tets,
    const faceList& triangles,
    const label nFirst,
    const std::function<bool(label)>& isPassed
)
{
    const frontTriangles barrier(triangles, points.size());
    const List<FixedList<label, 4>> neighbours
    (
        tetNeighbours(tets, points.size())
    );
    boolList isFront(tets.size(), false);
    DynamicList<label> found;

    const auto visit = [&](const label t)
    {
        if (t >= 0 && !isFront[t])
        {
            isFront[t] = true;
            found.append(t);
        }
    };

    forAll(tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label triangle = barrier.find(tets[t].face(i));

            if (triangle >= 0 && triangle < nFirst)
            {
                const face& f = triangles[triangle];
                const vector up(points[tets[t][i]] - points[f[0]]);
                visit((f.areaNormal(points) & up) > 0 ? t : -1);
            }
        }
    }

    for (label k = 0; k < found.size(); ++k)
    {
        for (label i = 0; i < 4; ++i)
        {
            const triFace f(tets[found[k]].face(i));

            if
            (
                barrier.find(f) < 0
             && (isPassed(f[0]) || isPassed(f[1]) || isPassed(f[2]))
            )
            {
                visit(neighbours[found[k]][i]);
            }
        }
    }

    return isFront;
}

} // End namespace Foam

// ************************************************************************* //
