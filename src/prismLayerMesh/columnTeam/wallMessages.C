/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallMessages.H"
#include "packedFaces.H"
#include "sideShape.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
