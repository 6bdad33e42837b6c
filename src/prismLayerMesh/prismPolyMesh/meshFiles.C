/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFiles.H"
#include "DynamicList.H"
#include "faceIOList.H"
#include "labelIOList.H"
#include "OStringStream.H"
#include "pointIOField.H"
#include "regIOobject.H"
#include "Time.H"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>

namespace Foam
{

namespace
{

//- Blocks of the same share of each file follow each other
struct fileBlock
{
    scalar share;
    label file;
    label block;

    bool operator<(const fileBlock& other) const { return share < other.share; }
};


//- Appends blocks to open files, each file in its order
class blockWriter
{
    //- The block of a file that is written next
    struct fileTurn
    {
        std::mutex mutex;
        std::condition_variable passed;
        label next = 0;
    };

    const std::vector<blockFile>& files_;
    const UList<Ostream*>& streams_;
    std::vector<fileTurn> turns_;

    //- The first failure: of a block, or the file that cannot be written
    std::mutex failing_;
    std::atomic<bool> failed_{false};
    std::exception_ptr failure_;
    fileName failedFile_;

    //- Notes a failure; after the first one nothing is written
    void fail(const std::exception_ptr& failure, const fileName& file)
    {
        const std::lock_guard<std::mutex> lock(failing_);
        if (!failed_)
        {
            failure_ = failure;
            failedFile_ = file;
            failed_ = true;
        }
    }

    std::string bytesOf(const fileBlock& b)
    {
        try
        {
            return failed_ ? std::string() : files_[b.file].bytes(b.block);
        }
        catch (...)
        {
            fail(std::current_exception(), "");
        }

        return std::string();
    }

    //- Writes a block after all earlier ones of its file
    void write(const fileBlock& b)
    {
        const std::string bytes(bytesOf(b));
        fileTurn& turn = turns_[b.file];
        std::unique_lock<std::mutex> lock(turn.mutex);
        turn.passed.wait(lock, [&]() { return turn.next == b.block; });

        Ostream& os = *streams_[b.file];
        if (!failed_ && !os.writeRaw(bytes.data(), bytes.size()).good())
        {
            fail(nullptr, files_[b.file].object.objectPath());
        }
        ++turn.next;
        turn.passed.notify_all();
    }

public:

    blockWriter
    (
        const std::vector<blockFile>& files,
        const UList<Ostream*>& streams
    )
    :
        files_(files),
        streams_(streams),
        turns_(files.size())
    {}

    void run()
    {
        std::vector<fileBlock> blocks;
        for (std::size_t i = 0; i < files_.size(); ++i)
        {
            const label n = files_[i].nBlocks;
            for (label block = 0; block < n; ++block)
            {
                blocks.push_back
                (
                    fileBlock{scalar(block)/n, label(i), block}
                );
            }
        }
        std::stable_sort(blocks.begin(), blocks.end());

        // Each thread takes the next block: the first one of those that are
        // being made waits for none
        const label n = blocks.size();
        #pragma omp parallel for schedule(monotonic: dynamic, 1)
        for (label i = 0; i < n; ++i)
        {
            write(blocks[i]);
        }

        if (failure_)
        {
            std::rethrow_exception(failure_);
        }
        if (failed_)
        {
            FatalErrorInFunction
                << "Cannot write all of " << failedFile_ << exit(FatalError);
        }
    }
};


//- An object of any class whose data somebody else writes
class streamedObject
:
    public regIOobject
{
    const word type_;
    const std::function<bool(Ostream&)> write_;

public:

    streamedObject
    (
        const blockFile& file,
        const std::function<bool(Ostream&)>& write
    )
    :
        regIOobject(file.object),
        type_(file.type),
        write_(write)
    {}

    virtual const word& type() const
    {
        return type_;
    }

    virtual bool writeData(Ostream& os) const
    {
        return write_(os);
    }
};

} // End anonymous namespace


//- Opens the file after those that are open. When all are open, writes all.
static void openAndWrite
(
    const std::vector<blockFile>& files,
    DynamicList<Ostream*>& open
)
{
    if (std::size_t(open.size()) == files.size())
    {
        blockWriter(files, open).run();
        return;
    }

    const blockFile& file = files[open.size()];
    const streamedObject object
    (
        file,
        [&](Ostream& os)
        {
            open.append(&os);
            openAndWrite(files, open);

            return os.good();
        }
    );

    if (!object.write())
    {
        FatalErrorInFunction
            << "Cannot write " << object.objectPath() << exit(FatalError);
    }
}


void writeBlocks(const std::vector<blockFile>& files)
{
    DynamicList<Ostream*> open;
    openAndWrite(files, open);
}


// * * * * * * * * * * * * * * *  Mesh Files * * * * * * * * * * * * * * * * //

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
            format, mesh.nFaces(), mesh.nFaceBlocks, i, facesOf(mesh.faces(i))
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
            starts[k] = mesh.firstFacePoints[i] + (k ? block.ends[k - 1] : 0);
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
