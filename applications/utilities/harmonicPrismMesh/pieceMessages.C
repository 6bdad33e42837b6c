/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pieceMessages.H"
#include "IPstream.H"
#include "OPstream.H"
#include "packedFaces.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const auto blocking = UPstream::commsTypes::scheduled;


//- Calls visit(list) for the long lists of a piece and of its faces
template<class Piece, class Faces, class Visit>
static void visitLists(Piece& piece, Faces& faces, const Visit& visit)
{
    visit(faces.sizes);
    visit(faces.corners);
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
    const packedFaces faces(piece.faces);
    DynamicList<label> lengths;
    visitLists
    (
        piece, faces, [&](const auto& list) { lengths.append(list.size()); }
    );

    {
        OPstream stream(blocking, other);
        stream
            << piece.patchNames << piece.patchTypes << piece.patchSizes
            << piece.processors << piece.processorSizes
            << piece.zoneNames << lengths;
    }

    visitLists(piece, faces, [&](const auto& list) { sendList(list, other); });
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

    packedFaces faces;
    label k = 0;
    visitLists
    (
        piece, faces,
        [&](auto& list)
        {
            list.setSize(lengths[k++]);
            receiveList(list, other);
        }
    );
    piece.faces = faces.unpacked();

    return piece;
}

} // End namespace Foam

// ************************************************************************* //
