/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeBlocks.H"
#include "DynamicList.H"
#include "regIOobject.H"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void writeBlocks(const std::vector<blockFile>& files)
{
    DynamicList<Ostream*> open;
    openAndWrite(files, open);
}

} // End namespace Foam

// ************************************************************************* //
