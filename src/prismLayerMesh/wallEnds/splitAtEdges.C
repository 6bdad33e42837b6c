/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "splitAtEdges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Returns a face in triangles without edges that have points; the face itself
//  if it has no such edges
static DynamicList<face> pieces
(
    const EdgeMap<label>& points,
    const face& whole
)
{
    DynamicList<face> left;
    DynamicList<face> done;
    left.append(whole);

    while (left.size())
    {
        const face f(left.remove());
        label k = 0;
        while (k < f.size() && !points.found(f.faceEdge(k)))
        {
            ++k;
        }

        if (k == f.size())
        {
            done.append(f);
            continue;
        }

        const label x = points[f.faceEdge(k)];
        for (label i = 1; i < f.size(); ++i)
        {
            const edge e(f.faceEdge((k + i) % f.size()));
            left.append(face({x, e.start(), e.end()}));
        }
    }

    return done;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList splitAtEdges(const EdgeMap<label>& points, wallSurface& surface)
{
    DynamicList<face> added;
    DynamicList<label> from;

    forAll(surface.faces, facei)
    {
        const DynamicList<face> all(pieces(points, surface.faces[facei]));
        surface.faces[facei] = all[0];

        for (label i = 1; i < all.size(); ++i)
        {
            added.append(all[i]);
            from.append(facei);
        }
    }

    surface.faces.append(added);
    const labelList patchIDs(surface.patchIDs, from);
    surface.patchIDs.append(patchIDs);

    return labelList(std::move(from));
}

} // End namespace Foam

// ************************************************************************* //
