/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "returnMemory.H"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

// ************************************************************************* //
