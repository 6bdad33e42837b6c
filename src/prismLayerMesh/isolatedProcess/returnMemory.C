/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "returnMemory.H"

#include <cstdlib>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

void Foam::returnMemory()
{
    #ifdef __GLIBC__
    malloc_trim(0);
    #endif
}


void Foam::keepLongListsApart()
{
    #ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 4*1024*1024);
    #endif
}


// * * * * * * * * * * * * * *  Wait Passively * * * * * * * * * * * * * * * //

void Foam::waitPassively(char* argv[])
{
    static const char* const policy = "OMP_WAIT_POLICY";

    if
    (
        !std::getenv(policy) && !std::getenv("GOMP_SPINCOUNT")
     && ::setenv(policy, "passive", 1) == 0
    )
    {
        ::execv("/proc/self/exe", argv);
    }
}

// ************************************************************************* //
