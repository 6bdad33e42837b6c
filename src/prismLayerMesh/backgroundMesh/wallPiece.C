/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallPiece.H"
#include "boundBox.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- How far a piece goes beyond its points [m]
static scalar reachOf
(
    const scalarField& radius,
    const labelUList& own,
    const pieceControls& controls
)
{
    return controls.reach*max(scalarField(radius, own));
}


static void divide
(
    const pointField& points,
    const scalarField& radius,
    const pieceControls& controls,
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
    DynamicList<label> inside;
    forAll(wall.faces, facei)
    {
        if (boundBox(wall.points, wall.faces[facei], false).overlaps(box))
        {
            inside.append(facei);
        }
    }

    return labelList(std::move(inside));
}


//- The points that a piece is for, then the others of its faces
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


static offsetEnvelope envelopeOf
(
    const offsetEnvelope& all,
    const labelUList& wallPoints,
    const boundBox& box
)
{
    labelList inside(all.points.size());
    label n = 0;
    offsetEnvelope part;

    forAll(all.points, i)
    {
        if (box.contains(all.points[i]))
        {
            part.nEnvelope += i < all.nEnvelope;
            inside[n++] = i;
        }
    }
    inside.setSize(n);

    part.radius = scalarField(all.radius, wallPoints);
    part.points = pointField(all.points, inside);
    part.gaps = scalarField(all.gaps, inside);

    return part;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelListList divideWall
(
    const pointField& points,
    const scalarField& radius,
    const pieceControls& controls
)
{
    labelList all(identity(points.size()));
    DynamicList<labelList> parts;
    divide(points, radius, controls, all, parts);

    return parts.size() > 1 ? labelListList(std::move(parts)) : labelListList();
}


wallPiece makeWallPiece
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const offsetEnvelope& envelope,
    const labelList& own,
    const pieceControls& controls
)
{
    boundBox box(wall.points, own, false);
    const point reach
    (
        point::uniform(reachOf(envelope.radius, own, controls))
    );
    box.min() -= reach;
    box.max() += reach;

    const labelList inside(facesIn(wall, box));
    wallPiece piece;
    piece.points = pointsOf(wall, own, inside);
    piece.nOwn = own.size();
    piece.envelope = envelopeOf(envelope, piece.points, box);
    piece.wall.points = pointField(wall.points, piece.points);

    const labelList local(invert(wall.points.size(), piece.points));
    labelList nFaces(piece.points.size(), 0);
    piece.wall.faces = faceList(wall.faces, inside);
    for (face& f : piece.wall.faces)
    {
        inplaceRenumber(local, f);
        for (const label p : f)
        {
            ++nFaces[p];
        }
    }

    piece.isWhole.setSize(nFaces.size());
    piece.pointPoints.setSize(nFaces.size());
    forAll(piece.points, p)
    {
        const label q = piece.points[p];
        piece.isWhole[p] = nFaces[p] == addressing.pointFaces[q].size();
        piece.pointPoints[p] =
            UIndirectList<label>(local, addressing.pointPoints[q]);
        inplaceSubsetList
        (
            piece.pointPoints[p], [](const label r) { return r >= 0; }
        );
    }

    return piece;
}

} // End namespace Foam

// ************************************************************************* //
