/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hostThreads.H"
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

label useThreadsOfHost()
{
    const label n = UPstream::nProcs(), own = UPstream::myProcNo();
    List<string> hosts(n);
    labelListList processors(n);
    labelList threads(n);
    hosts[own] = hostName();
    processors[own] = ownProcessors();
    threads[own] = omp_get_max_threads();
    Pstream::gatherList(hosts);
    Pstream::gatherList(processors);
    Pstream::gatherList(threads);

    if (!UPstream::master())
    {
        return threads[own];
    }

    cpu_set_t all;
    CPU_ZERO(&all);
    label nThreads = 0;

    forAll(hosts, i)
    {
        if (hosts[i] == hosts[own])
        {
            nThreads += threads[i];
            for (const label processor : processors[i])
            {
                CPU_SET(processor, &all);
            }
        }
    }

    nThreads = max(min(nThreads, label(CPU_COUNT(&all))), label(1));
    sched_setaffinity(0, sizeof(all), &all);
    omp_set_num_threads(nThreads);

    return nThreads;
}

} // End namespace Foam

// ************************************************************************* //
