/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frontPart.H"
#include "ListOps.H"
#include "sideShape.H"
#include "packedFaces.H"

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
    m.addList(items);
    m.addList(corners);

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
    m.addList(border);

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


// * * * * * * * * * * * * * * *  Wall Messages  * * * * * * * * * * * * * * //

static void addWords(message& m, const wordList& words)
{
    m.addValue(words.size());
    for (const word& w : words)
    {
        m.addText(w);
    }
}


static wordList takeWords(messageReader& reader)
{
    wordList words(reader.value<label>());
    for (word& w : words)
    {
        w = word(reader.text(), false);
    }

    return words;
}


static void addSide(message& m, const sidePatch& side)
{
    m.addValue(side.origin);
    m.addValue(side.normal);
    m.addText(side.name);
    m.addText(side.type);
    m.addList(side.points);
    addFaces(m, side.faces);
    m.addValue(side.isCurved());
}


static sidePatch takeSide(messageReader& reader)
{
    sidePatch side;
    side.origin = reader.value<point>();
    side.normal = reader.value<vector>();
    side.name = word(reader.text(), false);
    side.type = word(reader.text(), false);
    side.points = reader.list<point>();
    side.faces = takeFaces(reader);
    if (reader.value<bool>())
    {
        side.shape.reset(new sideShape(side.points, side.faces));
    }

    return side;
}


void addFaces(message& m, const faceList& faces)
{
    const packedFaces packed(faces);
    m.addList(packed.sizes);
    m.addList(packed.corners);
}


faceList takeFaces(messageReader& reader)
{
    packedFaces packed;
    packed.sizes = reader.list<label>();
    packed.corners = reader.list<label>();

    return packed.unpacked();
}


void addWall(message& m, const wallSurface& wall)
{
    m.addList(wall.points);
    addFaces(m, wall.faces);
    m.addList(wall.patchIDs);
    addWords(m, wall.patchNames);
    addWords(m, wall.patchTypes);
    m.addValue(wall.border.sides.size());
    for (const sidePatch& side : wall.border.sides)
    {
        addSide(m, side);
    }
    m.addList(wall.border.edges);
    m.addList(wall.border.edgeSides);
}


wallSurface takeWall(messageReader& reader)
{
    wallSurface wall;
    wall.points = reader.list<point>();
    wall.faces = takeFaces(reader);
    wall.patchIDs = reader.list<label>();
    wall.patchNames = takeWords(reader);
    wall.patchTypes = takeWords(reader);
    wall.border.sides.setSize(reader.value<label>());
    for (sidePatch& side : wall.border.sides)
    {
        side = takeSide(reader);
    }
    wall.border.edges = reader.list<edge>();
    wall.border.edgeSides = reader.list<label>();

    return wall;
}

} // End namespace Foam

// ************************************************************************* //
