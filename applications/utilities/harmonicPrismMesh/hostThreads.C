/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hostThreads.H"
#include "HashSet.H"
#include "labelList.H"
#include "OSspecific.H"
#include "Pstream.H"

#include <omp.h>
#include <sched.h>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

} // End namespace Foam

// ************************************************************************* //
