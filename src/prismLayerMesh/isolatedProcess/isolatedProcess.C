/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isolatedProcess.H"
#include "error.H"
#include "stageProgress.H"

#include <cerrno>
#include <cfenv>
#include <csignal>
#include <fcntl.h>
#include <mutex>
#include <omp.h>
#include <poll.h>
#include <set>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The ends from which this process reads what its children write. A child that
//  had the end of another child would keep the latter from noticing that nobody
//  reads any more.
struct openEnds
{
    std::mutex lock;
    std::set<int> reading;
};


static openEnds& ends()
{
    static openEnds all;

    return all;
}


//- Makes a pipe and a child of this process. No other thread makes a child
//  meanwhile, so that no child has the writing end of another. Returns the
//  process, 0 in the child, and negative if there is none; and the end that
//  this process uses.
static pid_t forkWithPipe(int& own)
{
    openEnds& all = ends();
    const std::lock_guard<std::mutex> guard(all.lock);
    int pair[2];

    if (::pipe(pair))
    {
        return -1;
    }

    // What other threads read is locked: nothing is flushed here, nor in the
    // child, which ends without that
    const pid_t child = ::fork();

    if (child == 0)
    {
        ::close(pair[0]);
        for (const int other : all.reading)
        {
            ::close(other);
        }
        all.reading.clear();
        own = pair[1];
    }
    else
    {
        ::close(pair[1]);
        own = pair[0];

        if (child > 0)
        {
            all.reading.insert(own);
        }
        else
        {
            ::close(own);
        }
    }

    return child;
}


static void closeEnd(std::FILE* in)
{
    openEnds& all = ends();
    const std::lock_guard<std::mutex> guard(all.lock);
    all.reading.erase(::fileno(in));
    std::fclose(in);
}


[[noreturn]] static void runChild
(
    const std::function<void(pipeWriter&)>& work,
    const unsigned cpuSeconds,
    const int writeEnd
)
{
    // OpenFOAM's handlers would print a stack, and a core file helps nobody
    for (const int sig : {SIGABRT, SIGFPE, SIGSEGV, SIGBUS, SIGXCPU})
    {
        std::signal(sig, SIG_DFL);
    }

    forgetProgress();

    // The threads of OpenMP have stayed in the parent
    omp_set_num_threads(1);

    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);

    if (cpuSeconds > 0)
    {
        // At the first it gets SIGXCPU, at the second it is killed
        const rlimit cpu{cpuSeconds, cpuSeconds + 1};
        ::setrlimit(RLIMIT_CPU, &cpu);
    }

    const int null = ::open("/dev/null", O_WRONLY);
    ::dup2(null, STDOUT_FILENO);
    ::dup2(null, STDERR_FILENO);

    std::fenv_t environment;
    std::feholdexcept(&environment);

    int status = 1;

    try
    {
        std::FILE* out = ::fdopen(writeEnd, "wb");
        pipeWriter writer(out);
        work(writer);
        status = std::fclose(out) ? 1 : 0;
    }
    catch (...)
    {}

    // Not exit: what this process holds belongs to its parent
    ::_exit(status);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

processEnd isolatedProcess
(
    const std::function<void(pipeWriter&)>& work,
    const std::function<void(pipeReader&)>& read,
    const unsigned cpuSeconds
)
{
    int end;
    const pid_t child = forkWithPipe(end);

    if (child < 0)
    {
        return processEnd::failed;
    }
    if (child == 0)
    {
        runChild(work, cpuSeconds, end);
    }

    pollfd first{end, POLLIN, 0};
    while (::poll(&first, 1, 1000) == 0)
    {
        tellSameProgress();
    }

    std::FILE* in = ::fdopen(end, "rb");
    bool complete = true;
    try
    {
        pipeReader reader(in);
        read(reader);
    }
    catch (const endOfPipe&)
    {
        complete = false;
    }
    closeEnd(in);

    int status = 1;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR)
    {}

    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    {
        return processEnd::tooLong;
    }

    return complete && WIFEXITED(status) && WEXITSTATUS(status) == 0
      ? processEnd::complete : processEnd::failed;
}

} // End namespace Foam

// ************************************************************************* //
