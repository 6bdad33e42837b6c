/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frontPart.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void frontCollector::sort()
{
    inplaceUniqueSort(columns_);
    inplaceUniqueSort(faces_);
    inplaceUniqueSort(border_);
}


void frontCollector::setColumns(frontPart& part) const
{
    layerFront& front = part.front;
    part.columns.setSize(columns_.size());
    front.surface.points.setSize(columns_.size());
    front.wallPoints.setSize(columns_.size());

    forAll(columns_, c)
    {
        part.columns[c] = columns_[c].whole;
        front.surface.points[c] = columns_[c].at;
    }
    placeInList place(part.columns);
    forAll(columns_, c)
    {
        front.wallPoints[c] = place(columns_[c].root);
    }
}


void frontCollector::setFaces(frontPart& part) const
{
    layerFront& front = part.front;
    part.faces.setSize(faces_.size());
    front.surface.faces.setSize(faces_.size());
    front.surface.patchIDs.setSize(faces_.size());
    front.nWallFaces = 0;

    placeInList place(part.columns);
    forAll(faces_, i)
    {
        const frontFace& from = faces_[i];
        part.faces[i] = from.whole;
        front.surface.patchIDs[i] = from.patch;
        front.nWallFaces += from.patch >= 0;

        face& f = front.surface.faces[i];
        f.setSize(from.nCorners);
        forAll(f, k)
        {
            f[k] = place(corners_[from.firstCorner + k]);
        }
    }
}


void frontCollector::addColumns
(
    message& m,
    const layerFront& front,
    const labelUList& columns,
    bitSet&& isIn
)
{
    const labelList chosen(isIn.toc());
    for (const label c : chosen)
    {
        isIn.set(front.wallPoints[c]);
    }

    DynamicList<frontColumn> items(chosen.size());
    for (const label c : isIn)
    {
        items.append
        (
            frontColumn
            {
                columns[c], columns[front.wallPoints[c]],
                front.surface.points[c]
            }
        );
    }
    m(items);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void frontCollector::addFaces
(
    message& m,
    const layerFront& front,
    const labelUList& columns,
    const labelUList& faces,
    const labelUList& which
)
{
    const wallSurface& surface = front.surface;
    bitSet isIn(columns.size());
    DynamicList<frontFace> items(which.size());
    DynamicList<label> corners(3*which.size());
    for (const label facei : which)
    {
        const face& f = surface.faces[facei];
        isIn.set(f);
        items.append
        (
            frontFace
            {
                faces[facei], surface.patchIDs[facei], corners.size(), f.size()
            }
        );
        for (const label c : f)
        {
            corners.append(columns[c]);
        }
    }

    DynamicList<borderEdge> border;
    forAll(surface.border.edges, i)
    {
        const edge& e = surface.border.edges[i];
        if (isIn.test(e.start()) && isIn.test(e.end()))
        {
            border.append
            (
                borderEdge
                ({
                    columns[e.start()], columns[e.end()],
                    surface.border.edgeSides[i]
                })
            );
        }
    }
    m(items, corners, border);

    addColumns(m, front, columns, std::move(isIn));
}


void frontCollector::take(messageReader& reader)
{
    const label first = corners_.size();
    for (frontFace f : reader.list<frontFace>())
    {
        f.firstCorner += first;
        faces_.append(f);
    }
    corners_.append(reader.list<label>());
    border_.append(reader.list<borderEdge>());
    columns_.append(reader.list<frontColumn>());
}


labelList frontCollector::wallPoints()
{
    sort();

    DynamicList<label> points(columns_.size());
    for (const frontColumn& c : columns_)
    {
        if (c.whole == c.root)
        {
            points.append(c.whole);
        }
    }

    return labelList(std::move(points));
}


frontPart frontCollector::part(const wallSurface& like)
{
    sort();

    frontPart part;
    setColumns(part);
    setFaces(part);

    wallSurface& surface = part.front.surface;
    surface.patchNames = like.patchNames;
    surface.patchTypes = like.patchTypes;
    surface.border.sides = like.border.sides;
    surface.border.edges.setSize(border_.size());
    surface.border.edgeSides.setSize(border_.size());
    placeInList place(part.columns);
    forAll(border_, i)
    {
        const borderEdge& e = border_[i];
        surface.border.edges[i] = edge(place(e[0]), place(e[1]));
        surface.border.edgeSides[i] = e[2];
    }

    return part;
}

} // End namespace Foam

// ************************************************************************* //
