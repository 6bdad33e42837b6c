/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "outlines.H"

#include "edge.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef DynamicList<labelPair, 64> directedEdges;


//- The directed edges of quadrilaterals. An edge goes together with its
//  opposite.
static directedEdges boundaryOf(const UList<cornerQuad>& quads)
{
    directedEdges rest;
    for (const cornerQuad& quad : quads)
    {
        for (label k = 0; k < 4; ++k)
        {
            const labelPair e(quad[k], quad[(k + 1) % 4]);
            const label opposite = rest.find(labelPair(e.second(), e.first()));
            if (opposite >= 0)
            {
                rest[opposite] = rest.last();
                rest.remove();
            }
            else if (e.first() != e.second())
            {
                rest.append(e);
            }
        }
    }

    return rest;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<labelList> outlinesOf(const UList<cornerQuad>& quads)
{
    directedEdges rest(boundaryOf(quads));

    // A walk along the edges. Where it comes to a point for the second time, it
    // has gone round an outline.
    DynamicList<labelList> outlines;
    DynamicList<label, 16> walk;
    while (rest.size())
    {
        label next = 0;
        while
        (
            walk.size() && next < rest.size()
         && rest[next].first() != walk.last()
        )
        {
            ++next;
        }
        if (next == rest.size())
        {
            walk.clear();
            continue;
        }
        const labelPair e(rest[next]);
        rest[next] = rest.last();
        rest.remove();
        if (walk.empty())
        {
            walk.append(e.first());
        }
        const label met = walk.find(e.second());
        if (met < 0)
        {
            walk.append(e.second());
            continue;
        }
        outlines.append
        (
            labelList(SubList<label>(walk, walk.size() - met, met))
        );
        walk.setSize(met);
        if (met > 0)
        {
            walk.append(e.second());
        }
    }

    return List<labelList>(std::move(outlines));
}

} // End namespace Foam

// ************************************************************************* //
