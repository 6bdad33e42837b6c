/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stageLog.H"
#include "IOmanip.H"
#include "IOstreams.H"

#include <sstream>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stageLog::begin(const word& stage)
{
    // The line is visible while the stage runs
    Info<< stage.c_str() << std::string(18 - stage.size(), ' ').c_str()
        << flush;

    costs_.append(stageCost());
    costs_.last().stage = stage;
    clock_.timeIncrement();
}


void Foam::stageLog::end(const string& sizes)
{
    stageCost& cost = costs_.last();
    cost.seconds = clock_.timeIncrement();
    cost.peakMemory = peakMemory();

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
