/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFiles.H"
#include "faceIOList.H"
#include "labelIOList.H"
#include "OStringStream.H"
#include "pointIOField.H"
#include "Time.H"
#include "writeBlocks.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The bytes of block i of a list in OpenFOAM's format.
//  size: number of all items of the list
//  items: the items of the block
template<class T>
static std::string bytesOf
(
    const IOstream::streamFormat format,
    const label size,
    const label nBlocks,
    const label i,
    const UList<T>& items
)
{
    OStringStream os(format);

    // Short lists, and lists of equal items, have forms of their own: they are
    // in one block
    if (nBlocks == 1)
    {
        os << items;
        return os.str();
    }

    const bool binary = format == IOstream::BINARY;
    const char* const newLine = binary ? "" : "\n";

    if (i == 0)
    {
        os << nl << size << nl << token::BEGIN_LIST << newLine;
    }
    if (binary)
    {
        os.writeRaw
        (
            reinterpret_cast<const char*>(items.cdata()),
            std::streamsize(items.size())*sizeof(T)
        );
    }
    else
    {
        for (const T& item : items)
        {
            os << item << newLine;
        }
    }
    if (i == nBlocks - 1)
    {
        os << token::END_LIST << newLine;
    }

    return os.str();
}


//- The mesh; if it is small, with all faces in one block
static meshBlocks joinSmall(const meshBlocks& mesh)
{
    static constexpr label small = 10000;
    if (mesh.nFaces() > small)
    {
        return mesh;
    }

    faceBlock all;
    for (label i = 0; i < mesh.nFaceBlocks; ++i)
    {
        const faceBlock block(mesh.faces(i));
        forAll(block.ends, k)
        {
            all.points.append(block.face(k));
            all.endFace
            (
                block.owner[k],
                k < block.neighbour.size() ? block.neighbour[k] : -1
            );
        }
    }

    meshBlocks joined(mesh);
    joined.nFaceBlocks = 1;
    joined.faces = [all](label) { return all; };
    joined.count();

    return joined;
}


static faceList facesOf(const faceBlock& block)
{
    faceList faces(block.ends.size());
    forAll(faces, i)
    {
        faces[i] = face(block.face(i));
    }

    return faces;
}


namespace
{

//- The parts of the files of a mesh
struct meshLists
{
    const meshBlocks& mesh;
    const IOstream::streamFormat format;

    std::string points(const label i) const
    {
        return bytesOf
        (
            format, mesh.nPoints, mesh.nPointBlocks, i, mesh.points(i)
        );
    }

    std::string faces(const label i) const
    {
        return bytesOf
        (
            format, mesh.nFaces(), mesh.nFaceBlocks, i,
            facesOf(mesh.faces(i))
        );
    }

    //- In binary the starts of all faces come first, then their points
    std::string compactFaces(const label i) const
    {
        const label n = mesh.nFaceBlocks;

        if (i >= n)
        {
            return bytesOf
            (
                format, mesh.firstFacePoints.last(), n, i - n,
                mesh.faces(i - n).points
            );
        }

        const faceBlock block(mesh.faces(i));
        labelList starts(block.ends.size() + (i == n - 1));
        forAll(starts, k)
        {
            starts[k] =
                mesh.firstFacePoints[i] + (k ? block.ends[k - 1] : 0);
        }

        return bytesOf(format, mesh.nFaces() + 1, n, i, starts);
    }

    std::string owner(const label i) const
    {
        return bytesOf
        (
            format, mesh.nFaces(), mesh.nFaceBlocks, i, mesh.faces(i).owner
        );
    }

    std::string neighbour(const label i) const
    {
        return bytesOf
        (
            format, mesh.nInternalFaces(), nInternalBlocks(), i,
            mesh.faces(i).neighbour
        );
    }

    //- Number of the blocks up to the last with internal faces, at least one
    label nInternalBlocks() const
    {
        label n = 1;
        while (mesh.firstInternal[n] < mesh.nInternalFaces())
        {
            ++n;
        }

        return n;
    }
};

} // End anonymous namespace


//- The note on sizes in the headers of the files owner and neighbour
static string sizesOf(const meshBlocks& mesh)
{
    return "nPoints:" + name(mesh.nPoints)
      + "  nCells:" + name(mesh.nCells)
      + "  nFaces:" + name(mesh.nFaces())
      + "  nInternalFaces:" + name(mesh.nInternalFaces());
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void writeWhole(const regIOobject& object)
{
    if (!object.write())
    {
        FatalErrorInFunction
            << "Cannot write " << object.objectPath() << exit(FatalError);
    }
}


void writeMeshFiles(const polyMesh& frame, const meshBlocks& blocks)
{
    const meshBlocks mesh(joinSmall(blocks));
    const IOstream::streamFormat format = frame.time().writeFormat();
    const bool binary = format == IOstream::BINARY;
    const meshLists lists{mesh, format};
    const auto object = [&](const char* name, const string& note)
    {
        IOobject io
        (
            name, frame.facesInstance(), polyMesh::meshSubDir, frame,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        );
        io.note() = note;

        return io;
    };
    const string sizes(sizesOf(mesh));
    const label n = mesh.nFaceBlocks;

    writeBlocks
    ({
        {
            object("points", ""), pointIOField::typeName, mesh.nPointBlocks,
            [&](const label i) { return lists.points(i); }
        },
        {
            object("faces", ""),
            binary ? faceCompactIOList::typeName : faceIOList::typeName,
            binary ? 2*n : n,
            [&](const label i)
            {
                return binary ? lists.compactFaces(i) : lists.faces(i);
            }
        },
        {
            object("owner", sizes), labelIOList::typeName, n,
            [&](const label i) { return lists.owner(i); }
        },
        {
            object("neighbour", sizes), labelIOList::typeName,
            lists.nInternalBlocks(),
            [&](const label i) { return lists.neighbour(i); }
        }
    });

    writeWhole(frame.boundaryMesh());
    if (frame.cellZones().size())
    {
        writeWhole(frame.cellZones());
    }
    if (frame.faceZones().size())
    {
        writeWhole(frame.faceZones());
    }
}

} // End namespace Foam

// ************************************************************************* //
