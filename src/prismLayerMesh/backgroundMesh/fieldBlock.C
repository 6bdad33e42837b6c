/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldBlock.H"
#include "boundBox.H"
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


//- The faces whose own boxes overlap a box
static labelList facesIn(const wallSurface& wall, const boundBox& box)
{
    return subsetList(identity(wall.faces.size()), [&](const label facei)
    {
        return boundBox(wall.points, wall.faces[facei], false).overlaps(box);
    });
}


//- The points that a block is for, then the others of its faces
static labelList pointsOf
(
    const wallSurface& wall,
    const labelList& own,
    const labelUList& faces
)
{
    boolList taken(wall.points.size(), false);
    for (const label facei : faces)
    {
        UIndirectList<bool>(taken, wall.faces[facei]) = true;
    }
    UIndirectList<bool>(taken, own) = false;

    labelList points(own);
    points.append(findIndices(taken, true));

    return points;
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
    const wallContext& context,
    const envelopeRadii& radii,
    const labelList& own,
    const blockControls& controls,
    const backgroundMeshControls& mesh,
    const scalar maxStretch
)
{
    const wallSurface& wall = context.wall;
    const wallAddressing& addressing = context.addressing;
    boundBox box(wall.points, own, false);
    const point reach(point::uniform(reachOf(radii.radius, own, controls)));
    box.min() -= reach;
    box.max() += reach;

    const labelList inside(facesIn(wall, box));
    fieldBlock block;
    block.points = pointsOf(wall, own, inside);
    block.nOwn = own.size();
    block.envelope =
        makeOffsetEnvelope(context, radii, block.points, mesh, maxStretch);
    block.wall.points = pointField(wall.points, block.points);

    const labelList local(invert(wall.points.size(), block.points));
    labelList nFaces(block.points.size(), 0);
    block.wall.faces = faceList(wall.faces, inside);
    for (face& f : block.wall.faces)
    {
        inplaceRenumber(local, f);
        for (const label p : f)
        {
            ++nFaces[p];
        }
    }

    block.isWhole.setSize(nFaces.size());
    block.pointPoints.setSize(nFaces.size());
    forAll(block.points, p)
    {
        const label q = block.points[p];
        block.isWhole[p] = nFaces[p] == addressing.pointFaces[q].size();
        block.pointPoints[p] =
            UIndirectList<label>(local, addressing.pointPoints[q]);
        inplaceSubsetList
        (
            block.pointPoints[p], [](const label r) { return r >= 0; }
        );
    }

    return block;
}

} // End namespace Foam

// ************************************************************************* //
