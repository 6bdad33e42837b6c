/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldBlock.H"
#include "surfacePart.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- How far a block goes beyond its points [m]
static scalar reachOf
(
    const scalarField& radius,
    const labelUList& own,
    const blockControls& controls
)
{
    return controls.reach*max(scalarField(radius, own));
}


static void divide
(
    const pointField& points,
    const scalarField& radius,
    const blockControls& controls,
    labelList& part,
    DynamicList<labelList>& parts
)
{
    const vector span(boundBox(points, part, false).span());
    const direction widest = findMax(span);

    if
    (
        part.size() <= controls.maxPoints
     || span[widest] < controls.leastWidth*reachOf(radius, part, controls)
    )
    {
        sort(part);
        parts.append(part);
        return;
    }

    const label half = part.size()/2;
    std::nth_element
    (
        part.begin(),
        part.begin() + half,
        part.end(),
        [&](const label p, const label q)
        {
            const scalar x = points[p][widest], y = points[q][widest];
            return x < y || (x == y && p < q);
        }
    );

    labelList first(SubList<label>(part, half));
    labelList second(SubList<label>(part, part.size() - half, half));
    divide(points, radius, controls, first, parts);
    divide(points, radius, controls, second, parts);
}


//- Sets what is whole, and the neighbours of points.
//  around: the addressing of the surroundings
//  nearPoints: labels in the surroundings of the points of the block
static void setNeighbours
(
    const wallAddressing& around,
    const labelUList& nearPoints,
    fieldBlock& block
)
{
    labelList nFaces(block.points.size(), 0);
    for (const face& f : block.wall.faces)
    {
        for (const label p : f)
        {
            ++nFaces[p];
        }
    }

    const labelList local(invert(around.pointFaces.size(), nearPoints));
    block.isWhole.setSize(nFaces.size());
    block.pointPoints.setSize(nFaces.size());
    forAll(block.points, p)
    {
        const label q = nearPoints[p];
        block.isWhole[p] = nFaces[p] == around.pointFaces[q].size();
        block.pointPoints[p] =
            UIndirectList<label>(local, around.pointPoints[q]);
        inplaceSubsetList
        (
            block.pointPoints[p], [](const label r) { return r >= 0; }
        );
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelListList divideWall
(
    const pointField& points,
    const scalarField& radius,
    const blockControls& controls
)
{
    labelList all(identity(points.size()));
    DynamicList<labelList> parts;
    divide(points, radius, controls, all, parts);

    return parts.size() > 1 ? labelListList(std::move(parts)) : labelListList();
}


fieldBlock makeFieldBlock
(
    const wallSurface& wall,
    const envelopeRadii& radii,
    const labelList& own,
    const blockControls& controls,
    const backgroundMeshControls& mesh,
    const scalar maxStretch
)
{
    const scalar reach = reachOf(radii.radius, own, controls);
    const boundBox box(widened(boundBox(wall.points, own, false), reach));
    const labelList inside(facesIn(wall, box));
    const boundBox around(widened(boxOfFaces(wall, inside), reach));
    bitSet others(pointsOf(faceList(wall.faces, inside), wall.points.size()));
    others.unset(own);

    fieldBlock block;
    block.points = own;
    block.points.append(others.toc());
    block.nOwn = own.size();
    block.wall = partOf(wall, block.points, inside);

    const surfacePart near(makeSurfacePart(wall, facesIn(wall, around)));
    wallContext context(near.surface);
    const labelList nearPoints(near.localPoints(block.points));
    block.envelope = makeOffsetEnvelope
    (
        context, radii.at(near.points), nearPoints, mesh, maxStretch
    );
    setNeighbours(context.addressing, nearPoints, block);
    block.search = std::move(context.search);

    return block;
}

} // End namespace Foam

// ************************************************************************* //
