/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runProgram.H"
#include "stageProgress.H"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
        tellSameProgress();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }

    if (WIFEXITED(status) && WEXITSTATUS(status) == notFound)
    {
        return programEnd::missing;
    }

    return WIFEXITED(status) && WEXITSTATUS(status) == 0
      ? programEnd::complete : programEnd::failed;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
