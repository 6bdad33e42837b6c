/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "parallelRun.H"
#include "decompositionMethod.H"
#include "hostThreads.H"
#include "IOdictionary.H"
#include "IPstream.H"
#include "OPstream.H"
#include "Time.H"

#include <omp.h>
#include <unistd.h>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- How often a process that waits looks for the master [microseconds]. Waiting
//  messages of MPI keep a processor busy, which the master's threads need.
static const unsigned lookInterval = 5000;

static const auto scheduled = UPstream::commsTypes::scheduled;


//- Wakes a process that sleeps
static void wake(const label process)
{
    const char byte = 0;
    UOPstream::write(scheduled, process, &byte, 1);
}


//- Sleeps until the master wakes this process
static void sleep()
{
    char byte = 0;
    const label request = UPstream::nRequests();
    UIPstream::read(UPstream::commsTypes::nonBlocking, 0, &byte, 1);
    while (!UPstream::finishedRequest(request))
    {
        usleep(lookInterval);
    }
    UPstream::resetRequests(request);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

parallelRun::parallelRun(const Time& time)
:
    parallel_(UPstream::parRun()),
    nProcesses_(parallel_ ? UPstream::nProcs() : 1),
    processor_(parallel_ ? UPstream::myProcNo() : 0),
    team_(nProcesses_, processor_)
{
    if (parallel_)
    {
        useShareOfHost();
        decomposeParDict_ = IOdictionary
        (
            IOobject
            (
                "decomposeParDict", time.system(), time,
                IOobject::MUST_READ, IOobject::NO_WRITE, false
            )
        );
    }

    setParallel(false);

    if (parallel_ && isMaster())
    {
        const label n = decomposeParDict_.get<label>("numberOfSubdomains");
        if (n != nProcesses_)
        {
            FatalErrorInFunction
                << "numberOfSubdomains of decomposeParDict is " << n
                << ", but there are " << nProcesses_ << " processes"
                << exit(FatalError);
        }
        decomposition_ = decompositionMethod::New(decomposeParDict_);
        Info<< nProcesses_ << " processes make the layers, this one on "
            << omp_get_max_threads() << " threads" << nl << endl;
    }
}


parallelRun::~parallelRun()
{
    setParallel(parallel_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList parallelRun::divide(const meshParts& parts) const
{
    return decomposition_->decompose
    (
        parts.neighbours, parts.centres, parts.weights
    );
}


void parallelRun::requireWritten() const
{
    string failure;
    for (label other = 1; other < nProcesses_; ++other)
    {
        string message;
        IPstream stream(scheduled, other);
        stream >> message;
        if (failure.empty() && message.size())
        {
            failure = "Process " + name(other) + ": " + message;
        }
    }
    for (label other = 1; other < nProcesses_; ++other)
    {
        OPstream stream(scheduled, other);
        stream << failure.empty();
    }

    if (failure.size())
    {
        FatalErrorInFunction << failure.c_str() << exit(FatalError);
    }
}


void parallelRun::begin() const
{
    if (!isMaster())
    {
        sleep();
    }
    for (label other = 1; isMaster() && other < nProcesses_; ++other)
    {
        wake(other);
    }
}


bool parallelRun::reportWritten(const string& message) const
{
    {
        OPstream stream(scheduled, 0);
        stream << message;
    }

    bool all = false;
    IPstream stream(scheduled, 0);
    stream >> all;

    return all;
}

} // End namespace Foam

// ************************************************************************* //
