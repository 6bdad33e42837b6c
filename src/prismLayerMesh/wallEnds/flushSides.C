/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flushSides.H"
#include "bitSet.H"
#include "disjointSets.H"
#include "EdgeMap.H"
#include "Map.H"

namespace Foam
{

//- Product of the normals of a face and of a side patch that continues it but
//  for rounding: cos(3 degrees). Heights beside it would be smaller by the sine
//  of the angle.
static constexpr scalar planeCosine = 0.9986;

//- Share of the length of a connected border. The wall may continue a side
//  patch on less of it: on 3 % at stem and stern of half a hull whose breadth
//  is zero there, where first heights are at least 0.57 of the request.
static constexpr scalar flushShare = 0.1;


scalar sideCosine
(
    const wallSurface& wall,
    const label facei,
    const sidePatch& side,
    const label p
)
{
    return wall.faces[facei].unitNormal(wall.points)
      & -side.planeAt(wall.points[p]).normal;
}


//- Returns the face of each edge of the border
static labelList facesOfBorder(const wallSurface& wall)
{
    const edgeList& edges = wall.border.edges;
    EdgeMap<label> labels(2*edges.size());
    forAll(edges, k)
    {
        labels.insert(edges[k], k);
    }

    labelList faces(edges.size(), -1);
    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];
        forAll(f, i)
        {
            const label k = labels.lookup(f.faceEdge(i), -1);
            if (k >= 0)
            {
                faces[k] = facei;
            }
        }
    }

    return faces;
}


labelList flushEdges(const wallSurface& wall)
{
    const edgeList& edges = wall.border.edges;
    const labelList faces(facesOfBorder(wall));
    disjointSets parts(connectedPoints(wall.points.size(), edges));
    Map<scalar> lengths, flushLengths;
    bitSet flush(edges.size());
    forAll(edges, k)
    {
        const edge& e = edges[k];
        const sidePatch& side = wall.border.sides[wall.border.edgeSides[k]];
        const label part = parts.find(e.start());
        const scalar length = e.mag(wall.points);
        lengths(part, 0) += length;
        if (sideCosine(wall, faces[k], side, e.start()) > planeCosine)
        {
            flush.set(k);
            flushLengths(part, 0) += length;
        }
    }

    DynamicList<label> found;
    for (const label k : flush)
    {
        const label part = parts.find(edges[k].start());
        if (flushLengths[part] > flushShare*lengths[part])
        {
            found.append(k);
        }
    }

    return labelList(std::move(found));
}

} // End namespace Foam

// ************************************************************************* //
