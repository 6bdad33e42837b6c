/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "parallelRun.H"
#include "decompositionMethod.H"
#include "HashSet.H"
#include "IOdictionary.H"
#include "labelList.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "Time.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <omp.h>
#include <sched.h>
#include <unistd.h>

namespace Foam
{

//- Returns the processors on which this process may run, in ascending order
static labelList ownProcessors()
{
    cpu_set_t set;
    CPU_ZERO(&set);
    sched_getaffinity(0, sizeof(set), &set);
    DynamicList<label> processors;

    for (label i = 0; i < CPU_SETSIZE; ++i)
    {
        if (CPU_ISSET(i, &set))
        {
            processors.append(i);
        }
    }

    return labelList(std::move(processors));
}


void useShareOfHost()
{
    const label own = UPstream::myProcNo();
    List<string> hosts(UPstream::nProcs());
    labelListList processors(UPstream::nProcs());
    hosts[own] = hostName();
    processors[own] = ownProcessors();
    Pstream::gatherList(hosts);
    Pstream::scatterList(hosts);
    Pstream::gatherList(processors);
    Pstream::scatterList(processors);

    labelHashSet ofHost;
    label nProcesses = 0;
    forAll(hosts, i)
    {
        if (hosts[i] == hosts[own])
        {
            ofHost.insert(processors[i]);
            ++nProcesses;
        }
    }

    if (!env("OMP_NUM_THREADS"))
    {
        omp_set_num_threads(max(ofHost.size()/nProcesses, label(1)));
    }
}


// * * * * * * * * * * * * * * *  Parallel Run * * * * * * * * * * * * * * * //

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


string parallelRun::firstFailure(const string& failure) const
{
    const List<char> text(failure.begin(), failure.end());
    const List<List<char>> all
    (
        team().exchangeLists(List<List<char>>(size(), text))
    );
    forAll(all, p)
    {
        if (all[p].size())
        {
            return
                (p ? "Process " + name(p) + ": " : string())
              + std::string(all[p].cdata(), all[p].size());
        }
    }

    return "";
}

} // End namespace Foam

// ************************************************************************* //
