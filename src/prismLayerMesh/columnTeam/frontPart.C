/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frontPart.H"
#include "placeInList.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Sorts items by label, and keeps each once
template<class Item>
static void makeUnique(DynamicList<Item>& items)
{
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b)
    {
        return a.whole < b.whole;
    });
    const auto end = std::unique
    (
        items.begin(), items.end(),
        [](const Item& a, const Item& b) { return a.whole == b.whole; }
    );
    items.setSize(end - items.begin());
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void frontCollector::sort()
{
    makeUnique(columns_);
    makeUnique(faces_);

    const auto before = [](const borderEdge& a, const borderEdge& b)
    {
        return a.columns.start() < b.columns.start()
            || (
                    a.columns.start() == b.columns.start()
                 && a.columns.end() < b.columns.end()
                );
    };
    std::sort(border_.begin(), border_.end(), before);
    const auto end = std::unique
    (
        border_.begin(), border_.end(),
        [&](const borderEdge& a, const borderEdge& b)
        {
            return !before(a, b) && !before(b, a);
        }
    );
    border_.setSize(end - border_.begin());
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
    m.addList(items);
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
    bitSet isIn(columns.size());
    labelList patches(which.size()), sizes(which.size());
    DynamicList<label> corners(3*which.size());
    forAll(which, i)
    {
        const face& f = front.surface.faces[which[i]];
        isIn.set(f);
        patches[i] = front.surface.patchIDs[which[i]];
        sizes[i] = f.size();
        for (const label c : f)
        {
            corners.append(columns[c]);
        }
    }
    m.addList(labelList(UIndirectList<label>(faces, which)));
    m.addList(patches);
    m.addList(sizes);
    m.addList(corners);

    DynamicList<borderEdge> border;
    forAll(front.surface.border.edges, i)
    {
        const edge& e = front.surface.border.edges[i];
        if (isIn.test(e.start()) && isIn.test(e.end()))
        {
            border.append
            (
                borderEdge
                {
                    edge(columns[e.start()], columns[e.end()]),
                    front.surface.border.edgeSides[i]
                }
            );
        }
    }
    m.addList(border);

    addColumns(m, front, columns, std::move(isIn));
}


void frontCollector::take(messageReader& reader)
{
    const labelList faces(reader.list<label>());
    const labelList patches(reader.list<label>());
    const labelList sizes(reader.list<label>());
    label next = corners_.size();
    corners_.append(reader.list<label>());
    forAll(faces, i)
    {
        faces_.append(frontFace{faces[i], patches[i], next, sizes[i]});
        next += sizes[i];
    }
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
        const edge& e = border_[i].columns;
        surface.border.edges[i] = edge(place(e.start()), place(e.end()));
        surface.border.edgeSides[i] = border_[i].side;
    }

    return part;
}

} // End namespace Foam

// ************************************************************************* //
