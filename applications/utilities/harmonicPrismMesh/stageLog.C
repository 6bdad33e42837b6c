/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stageLog.H"
#include "IOmanip.H"
#include "IOstreams.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Seconds from one line of progress of a stage to the next
static constexpr double progressInterval = 5;


static std::string heading(const Foam::word& stage)
{
    return stage + std::string(18 - stage.size(), ' ');
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stageLog::stageLog()
{
    listenToProgress([this](const progressStep& step) { tell(step); });
}


Foam::stageLog::~stageLog()
{
    listenToProgress({});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stageLog::tell(const progressStep& step)
{
    const double seconds = clock_.elapsedTime();
    if (seconds < nextProgress_)
    {
        return;
    }
    nextProgress_ = seconds + progressInterval;

    std::ostringstream line;
    line<< (isInterrupted_ ? "" : "\n") << "    " << step.what;

    if (step.done)
    {
        line<< ' ' << step.done;
    }
    if (step.total)
    {
        line<< " of " << step.total;
    }
    line<< (*step.what ? ", " : "") << label(seconds) << " s\n";

    Info<< line.str().c_str() << flush;
    isInterrupted_ = true;
}


void Foam::stageLog::begin(const word& stage)
{
    // The line is visible while the stage runs
    Info<< heading(stage).c_str() << flush;

    costs_.append(stageCost());
    costs_.last().stage = stage;
    clock_.resetTime();
    nextProgress_ = progressInterval;
    isInterrupted_ = false;
    tellProgress("");
}


void Foam::stageLog::end(const string& sizes)
{
    stageCost& cost = costs_.last();
    cost.seconds = clock_.elapsedTime();
    cost.peakMemory = peakMemory();

    if (isInterrupted_)
    {
        Info<< heading(cost.stage).c_str();
    }

    // The seconds are on the first line
    const auto lineEnd = sizes.find('\n');

    Info<< sizes.substr(0, lineEnd).c_str() << "  "
        << setprecision(3) << cost.seconds << " s"
        << setprecision(IOstream::defaultPrecision()) << nl;

    if (lineEnd != std::string::npos)
    {
        std::istringstream lines(sizes.substr(lineEnd + 1));

        for (std::string line; std::getline(lines, line);)
        {
            Info<< "    " << line.c_str() << nl;
        }
    }

    Info<< flush;
}


Foam::stageObserver Foam::stageLog::observer()
{
    return stageObserver
    {
        [this](const word& stage) { begin(stage); },
        [this](const string& sizes) { end(sizes); }
    };
}


// ************************************************************************* //
