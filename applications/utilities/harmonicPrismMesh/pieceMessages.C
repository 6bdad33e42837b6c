/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pieceMessages.H"
#include "IPstream.H"
#include "OPstream.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const auto blocking = UPstream::commsTypes::scheduled;


//- The long lists of a piece but its faces, for visit(list)
template<class Piece, class Visit>
static void visitLists(Piece& piece, const Visit& visit)
{
    visit(piece.points);
    visit(piece.owner);
    visit(piece.neighbour);
    visit(piece.cellAddressing);
    visit(piece.pointAddressing);
    visit(piece.faceAddressing);
    for (auto& zone : piece.zones)
    {
        visit(zone);
    }
}


//- Calls transfer(first byte, number of bytes) for the messages of a list
template<class Type, class Transfer>
static void visitMessages(const UList<Type>& list, const Transfer& transfer)
{
    const std::streamsize most = 1 << 30;
    const std::streamsize size = std::streamsize(list.size())*sizeof(Type);

    for (std::streamsize first = 0; first < size; first += most)
    {
        transfer(first, std::min(most, size - first));
    }
}


template<class Type>
static void sendList(const UList<Type>& list, const label other)
{
    const char* bytes = reinterpret_cast<const char*>(list.cdata());
    visitMessages
    (
        list,
        [&](const std::streamsize first, const std::streamsize n)
        {
            UOPstream::write(blocking, other, bytes + first, n);
        }
    );
}


template<class Type>
static void receiveList(UList<Type>& list, const label other)
{
    char* bytes = reinterpret_cast<char*>(list.data());
    visitMessages
    (
        list,
        [&](const std::streamsize first, const std::streamsize n)
        {
            UIPstream::read(blocking, other, bytes + first, n);
        }
    );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void sendPiece(const meshPiece& piece, const label other)
{
    labelList sizes(piece.faces.size());
    DynamicList<label> corners(4*sizes.size());
    forAll(sizes, i)
    {
        sizes[i] = piece.faces[i].size();
        corners.append(piece.faces[i]);
    }

    DynamicList<label> lengths;
    lengths.append(sizes.size());
    lengths.append(corners.size());
    visitLists
    (
        piece, [&](const auto& list) { lengths.append(list.size()); }
    );

    {
        OPstream stream(blocking, other);
        stream
            << piece.patchNames << piece.patchTypes << piece.patchSizes
            << piece.processors << piece.processorSizes
            << piece.zoneNames << lengths;
    }

    sendList(sizes, other);
    sendList(corners, other);
    visitLists(piece, [&](const auto& list) { sendList(list, other); });
}


meshPiece receivePiece(const label other)
{
    meshPiece piece;
    labelList lengths;
    {
        IPstream stream(blocking, other);
        stream
            >> piece.patchNames >> piece.patchTypes >> piece.patchSizes
            >> piece.processors >> piece.processorSizes
            >> piece.zoneNames >> lengths;
    }
    piece.zones.setSize(piece.zoneNames.size());

    labelList sizes(lengths[0]), corners(lengths[1]);
    receiveList(sizes, other);
    receiveList(corners, other);

    label k = 2;
    visitLists
    (
        piece,
        [&](auto& list)
        {
            list.setSize(lengths[k++]);
            receiveList(list, other);
        }
    );

    piece.faces.setSize(sizes.size());
    label start = 0;
    forAll(sizes, i)
    {
        face& f = piece.faces[i];
        f.setSize(sizes[i]);
        std::copy_n(corners.begin() + start, sizes[i], f.begin());
        start += sizes[i];
    }

    return piece;
}

} // End namespace Foam

// ************************************************************************* //
