/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallPart.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether each point of a wall is a corner of one of the faces
static boolList pointsOf(const wallSurface& wall, const UList<bool>& faces)
{
    boolList isCorner(wall.points.size(), false);
    forAll(wall.faces, facei)
    {
        if (faces[facei])
        {
            UIndirectList<bool>(isCorner, wall.faces[facei]) = true;
        }
    }

    return isCorner;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList wallPart::localPoints(const labelUList& wallPoints) const
{
    labelList local(wallPoints.size());
    forAll(local, i)
    {
        local[i] = std::lower_bound
        (
            points.begin(), points.end(), wallPoints[i]
        ) - points.begin();
    }

    return local;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

boundBox widened(boundBox box, const scalar distance)
{
    const vector all(vector::uniform(distance));
    box.min() -= all;
    box.max() += all;

    return box;
}


boolList facesIn(const wallSurface& wall, const boundBox& box)
{
    boolList inside(wall.faces.size());
    forAll(inside, facei)
    {
        inside[facei] =
            boundBox(wall.points, wall.faces[facei], false).overlaps(box);
    }

    return inside;
}


boundBox boxOfFaces(const wallSurface& wall, const UList<bool>& faces)
{
    boundBox box(boundBox::invertedBox);
    forAll(faces, facei)
    {
        if (faces[facei])
        {
            box.add(wall.points, wall.faces[facei]);
        }
    }

    return box;
}


List<boundBox> boxesAround(const pointField& points, const scalar distance)
{
    const label groupSize = 4096;
    DynamicList<boundBox> boxes;
    for (label first = 0; first < points.size(); first += groupSize)
    {
        const label n = min(groupSize, points.size() - first);
        const boundBox box(SubList<point>(points, n, first), false);
        boxes.append(widened(box, distance));
    }

    return List<boundBox>(std::move(boxes));
}


wallPart makeWallPart(const wallSurface& wall, const UList<bool>& faces)
{
    const labelList chosen(findIndices(faces, true));
    wallPart part;
    part.points = findIndices(pointsOf(wall, faces), true);

    part.wall.points = pointField(wall.points, part.points);
    part.wall.faces = faceList(wall.faces, chosen);
    part.wall.patchIDs = UIndirectList<label>(wall.patchIDs, chosen);
    part.wall.patchNames = wall.patchNames;
    part.wall.patchTypes = wall.patchTypes;
    part.wall.border.sides = wall.border.sides;

    const labelList local(invert(wall.points.size(), part.points));
    for (face& f : part.wall.faces)
    {
        inplaceRenumber(local, f);
    }

    return part;
}

} // End namespace Foam

// ************************************************************************* //
