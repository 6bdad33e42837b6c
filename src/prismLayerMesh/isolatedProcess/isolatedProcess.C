/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isolatedProcess.H"
#include "error.H"

#include <cerrno>
#include <cfenv>
#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

[[noreturn]] static void runChild
(
    const std::function<void(std::FILE*)>& work,
    const unsigned cpuSeconds,
    const int writeEnd
)
{
    // OpenFOAM's handlers would print a stack, and a core file helps nobody
    for (const int sig : {SIGABRT, SIGFPE, SIGSEGV, SIGBUS, SIGXCPU})
    {
        std::signal(sig, SIG_DFL);
    }

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
        work(out);
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
    const std::function<void(std::FILE*)>& work,
    const std::function<bool(std::FILE*)>& read,
    const unsigned cpuSeconds
)
{
    int ends[2];

    if (::pipe(ends))
    {
        return processEnd::failed;
    }

    // What other threads read is locked: nothing is flushed here, nor in the
    // child, which ends without that
    const pid_t child = ::fork();

    if (child == 0)
    {
        ::close(ends[0]);
        runChild(work, cpuSeconds, ends[1]);
    }

    ::close(ends[1]);
    std::FILE* in = ::fdopen(ends[0], "rb");
    const bool complete = child > 0 && read(in);
    std::fclose(in);

    int status = 1;
    while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR)
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
