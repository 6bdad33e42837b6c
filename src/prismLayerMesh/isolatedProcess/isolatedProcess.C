/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isolatedProcess.H"
#include "error.H"
#include "OSspecific.H"
#include "stageProgress.H"

#include <cerrno>
#include <cfenv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <mutex>
#include <omp.h>
#include <set>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace Foam
{

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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

scratchFolder::scratchFolder()
{
    const char* base = std::getenv("TMPDIR");
    std::string path(base && *base ? base : "/tmp");
    path += "/harmonicPrismMeshXXXXXX";

    if (!::mkdtemp(&path[0]))
    {
        FatalErrorInFunction
            << "Cannot make the temporary folder " << path.c_str() << nl
            << "Set TMPDIR to a folder with room that you may write to"
            << exit(FatalError);
    }
    path_ = path;
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

scratchFolder::~scratchFolder()
{
    rmDir(path_);
}


// * * * * * * * * * * * * * * *  Run Program  * * * * * * * * * * * * * * * //

//- Statuses of a child that could not become the program, as of a shell
static const int notFound = 127;
static const int notRun = 126;


//- The strings as execvp wants them. They must outlive the result.
static std::vector<char*> pointers(std::vector<std::string>& strings)
{
    std::vector<char*> result;
    for (std::string& s : strings)
    {
        result.push_back(&s[0]);
    }
    result.push_back(nullptr);

    return result;
}


[[noreturn]] static void becomeProgram
(
    std::vector<char*>& command,
    std::vector<char*>& environment,
    const std::string& folder,
    const std::string& log
)
{
    // A group of its own, whose processes end together
    ::setpgid(0, 0);

    #ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    #endif

    if (::chdir(folder.c_str()))
    {
        ::_exit(notRun);
    }

    const int in = ::open("/dev/null", O_RDONLY);
    const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(in, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(out, STDERR_FILENO);

    for (char* variable : environment)
    {
        if (variable)
        {
            ::putenv(variable);
        }
    }

    ::execvp(command[0], command.data());
    ::_exit(errno == ENOENT ? notFound : notRun);
}


//- Waits for the child, or kills its group at the time limit
static programEnd waitFor(const pid_t child, const double seconds)
{
    typedef std::chrono::steady_clock clock;
    const clock::time_point start = clock::now();
    int status = 1;
    pid_t ended;

    while ((ended = ::waitpid(child, &status, WNOHANG)) != child)
    {
        if (ended < 0 && errno != EINTR)
        {
            return programEnd::failed;
        }

        const std::chrono::duration<double> passed(clock::now() - start);
        if (passed.count() > seconds)
        {
            ::kill(-child, SIGKILL);
            ::kill(child, SIGKILL);
            while (::waitpid(child, &status, 0) < 0 && errno == EINTR)
            {}

            return programEnd::tooLong;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }

    if (WIFEXITED(status) && WEXITSTATUS(status) == notFound)
    {
        return programEnd::missing;
    }

    return WIFEXITED(status) && WEXITSTATUS(status) == 0
      ? programEnd::complete : programEnd::failed;
}


programEnd runProgram
(
    const std::vector<std::string>& command,
    const std::vector<std::string>& environment,
    const std::string& folder,
    const std::string& log,
    const double seconds
)
{
    std::vector<std::string> words(command), variables(environment);
    std::vector<char*> arguments(pointers(words)), set(pointers(variables));

    const pid_t child = ::fork();

    if (child < 0)
    {
        return programEnd::failed;
    }
    if (child == 0)
    {
        becomeProgram(arguments, set, folder, log);
    }

    return waitFor(child, seconds);
}

} // End namespace Foam

// ************************************************************************* //
