/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCertificate.H"
#include "labelledTriangle.H"

#include <cmath>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static bool isFinite(const point& p)
{
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}


//- Cuts faces into fans, and leaves out the triangles that have no area or are
//  not finite. A face with a triangle that is not finite or, with addFlat, has
//  no area is paired with itself.
static std::vector<labelledTriangle> fansOf
(
    const polyhedralMesh& mesh,
    const labelUList& faces,
    const bool addFlat,
    DynamicList<labelPair>& pairs
)
{
    DynamicList<face> fans;
    DynamicList<label> faceOf;

    for (const label facei : faces)
    {
        const face& f = mesh.faces()[facei];

        for (label k = 1; k + 1 < f.size(); ++k)
        {
            fans.append(face({f[0], f[k], f[k + 1]}));
            faceOf.append(facei);
        }
    }

    std::vector<labelledTriangle> sound;

    for
    (
        const labelledTriangle& t
      : labelledTriangles(fans, mesh.points(), faceOf)
    )
    {
        const bool finite =
            isFinite(t.points[0]) && isFinite(t.points[1])
         && isFinite(t.points[2]);

        if (finite && !t.degenerate())
        {
            sound.push_back(t);
        }
        else if (addFlat || !finite)
        {
            pairs.append(labelPair(t.facei, t.facei));
        }
    }

    return sound;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<labelPair> findIntersections
(
    const polyhedralMesh& mesh,
    const labelUList& wallFaces,
    const labelUList& outerFaces
)
{
    DynamicList<labelPair> pairs;
    std::vector<labelledTriangle> triangles
    (
        fansOf(mesh, wallFaces, false, pairs)
    );
    const std::vector<labelledTriangle> outer
    (
        fansOf(mesh, outerFaces, true, pairs)
    );
    triangles.insert(triangles.end(), outer.begin(), outer.end());

    addIntersections(triangles, {}, pairs);

    return List<labelPair>(std::move(pairs));
}

} // End namespace Foam

// ************************************************************************* //
