/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pluginVersion.H"
#include "foamVersion.H"

#include <algorithm>
#include <cstring>
#include <iostream>

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool Foam::versionIsAsked(const int argc, const char* const* argv)
{
    const bool isAsked = std::any_of
    (
        argv + 1, argv + argc,
        [](const char* argument) { return !std::strcmp(argument, "-version"); }
    );

    if (isAsked)
    {
        std::cout
            << "harmonicPrismMesh " << pluginVersion << ", OpenFOAM v"
            << foamVersion::api << std::endl;
    }

    return isAsked;
}


// ************************************************************************* //
