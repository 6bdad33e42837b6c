/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stageLog.H"
#include "IOmanip.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static std::string heading(const Foam::word& stage)
{
    return stage + std::string(18 - stage.size(), ' ');
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stageLog::stageLog(Ostream& os, const double interval)
:
    os_(os),
    interval_(interval)
{
    listenToProgress
    (
        [this](const progressStep& step) { tell(step); }, interval/5
    );
}


Foam::stageLog::~stageLog()
{
    listenToProgress({});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stageLog::tell(const progressStep& step)
{
    const std::lock_guard<std::mutex> guard(lock_);
    const double seconds = clock_.elapsedTime();
    if (seconds < nextProgress_)
    {
        return;
    }
    nextProgress_ = seconds + interval_;

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

    os_ << line.str().c_str() << flush;
    isInterrupted_ = true;
}


void Foam::stageLog::writeLoopsAtBound(const std::vector<loopAtBound>& loops)
{
    const char* before = "    ";
    for (const loopAtBound& loop : loops)
    {
        os_ << before << "loop '" << loop.what << "' ended ";

        if (loop.count > 1)
        {
            os_ << loop.count << " times ";
        }
        os_ << "at its bound of " << loop.bound;
        before = "; ";
    }
    os_ << (*before == ';' ? "\n" : "");
}


void Foam::stageLog::begin(const word& stage)
{
    {
        // The line is visible while the stage runs
        const std::lock_guard<std::mutex> guard(lock_);
        os_ << heading(stage).c_str() << flush;

        costs_.append(stageCost());
        costs_.last().stage = stage;
        clock_.resetTime();
        nextProgress_ = interval_;
        isInterrupted_ = false;
    }
    tellProgress("");
}


void Foam::stageLog::end(const string& sizes)
{
    // Whoever tells progress has the lock of the steps, then this log's
    const std::vector<loopAtBound> loops(takeLoopsAtBound());
    const std::lock_guard<std::mutex> guard(lock_);
    nextProgress_ = GREAT;
    stageCost& cost = costs_.last();
    cost.seconds = clock_.elapsedTime();
    cost.peakMemory = peakMemory();

    if (isInterrupted_)
    {
        os_ << heading(cost.stage).c_str();
    }

    // The seconds are on the first line
    const auto lineEnd = sizes.find('\n');

    os_ << sizes.substr(0, lineEnd).c_str() << "  "
        << setprecision(3) << cost.seconds << " s"
        << setprecision(IOstream::defaultPrecision()) << nl;

    if (lineEnd != std::string::npos)
    {
        std::istringstream lines(sizes.substr(lineEnd + 1));

        for (std::string line; std::getline(lines, line);)
        {
            os_ << "    " << line.c_str() << nl;
        }
    }

    writeLoopsAtBound(loops);
    os_ << flush;
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
