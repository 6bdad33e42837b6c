/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfacePart.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList surfacePart::localPoints(const labelUList& wholePoints) const
{
    labelList local(wholePoints.size());
    forAll(local, i)
    {
        local[i] = std::lower_bound
        (
            points.begin(), points.end(), wholePoints[i]
        ) - points.begin();
    }

    return local;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bitSet pointsOf(const UList<face>& faces, const label nPoints)
{
    bitSet points(nPoints);
    for (const face& f : faces)
    {
        points.set(f);
    }

    return points;
}


wallSurface partOf
(
    const wallSurface& whole,
    const labelUList& points,
    const labelUList& faces
)
{
    wallSurface part;
    part.points = pointField(whole.points, points);
    part.faces = faceList(whole.faces, faces);
    part.patchIDs = UIndirectList<label>(whole.patchIDs, faces);
    part.patchNames = whole.patchNames;
    part.patchTypes = whole.patchTypes;
    part.border.sides = whole.border.sides;

    const labelList local(invert(whole.points.size(), points));
    for (face& f : part.faces)
    {
        inplaceRenumber(local, f);
    }

    return part;
}


surfacePart makeSurfacePart(const wallSurface& whole, const labelUList& faces)
{
    surfacePart part;
    part.faces = faces;
    part.points = pointsOf
    (
        faceList(whole.faces, faces), whole.points.size()
    ).toc();
    part.surface = partOf(whole, part.points, faces);

    return part;
}


void appendSurface
(
    const wallSurface& other,
    const labelUList& common,
    wallSurface& surface
)
{
    const label n = other.points.size() - common.size();
    labelList labels(common);
    labels.append(identity(n, surface.points.size()));
    surface.points.append(SubList<point>(other.points, n, common.size()));

    faceList faces(other.faces);
    for (face& f : faces)
    {
        inplaceRenumber(labels, f);
    }
    labelList patchIDs(other.patchIDs);
    for (label& patchi : patchIDs)
    {
        patchi += surface.patchNames.size();
    }
    surface.faces.append(faces);
    surface.patchIDs.append(patchIDs);
    surface.patchNames.append(other.patchNames);
    surface.patchTypes.append(other.patchTypes);
}


labelList removeUnusedPoints(faceList& faces, pointField& points)
{
    const bitSet used(pointsOf(faces, points.size()));
    const labelList numbers(invert(used));
    inplaceSubset(used, points);
    for (face& f : faces)
    {
        inplaceRenumber(numbers, f);
    }

    return numbers;
}


void keepFaces(const bitSet& kept, wallSurface& surface)
{
    inplaceSubset(kept, surface.faces);
    inplaceSubset(kept, surface.patchIDs);
    removeUnusedPoints(surface.faces, surface.points);
}


void mergePatches(wallSurface& wall)
{
    bitSet used(wall.patchNames.size());
    used.set(wall.patchIDs);

    DynamicList<word> names, types;
    labelList numbers(used.size(), -1);
    for (const label i : used)
    {
        numbers[i] = names.find(wall.patchNames[i]);

        if (numbers[i] < 0)
        {
            numbers[i] = names.size();
            names.append(wall.patchNames[i]);

            if (wall.patchTypes.size())
            {
                types.append(wall.patchTypes[i]);
            }
        }
    }

    inplaceRenumber(numbers, wall.patchIDs);
    wall.patchNames = names;
    wall.patchTypes = types;
}


boundBox widened(boundBox box, const scalar distance)
{
    const vector all(vector::uniform(distance));
    box.min() -= all;
    box.max() += all;

    return box;
}


labelList facesIn(const wallSurface& wall, const boundBox& box)
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


boundBox boxOfFaces(const wallSurface& wall, const labelUList& faces)
{
    boundBox box(boundBox::invertedBox);
    for (const label facei : faces)
    {
        box.add(wall.points, wall.faces[facei]);
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

} // End namespace Foam

// ************************************************************************* //
