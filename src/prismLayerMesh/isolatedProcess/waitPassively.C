/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "waitPassively.H"

#include <cstdlib>
#include <unistd.h>

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
