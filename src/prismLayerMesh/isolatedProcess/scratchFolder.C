/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scratchFolder.H"
#include "error.H"
#include "OSspecific.H"

#include <cstdlib>

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

scratchFolder::scratchFolder()
{
    const char* base = std::getenv("TMPDIR");
    std::string path(base && *base ? base : "/tmp");
    path += "/harmonicPrismMeshXXXXXX";

    if (!::mkdtemp(&path[0]))
    {
        FatalErrorInFunction
            << "no temporary folder " << path.c_str() << exit(FatalError);
    }
    path_ = path;
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

scratchFolder::~scratchFolder()
{
    rmDir(path_);
}

} // End namespace Foam

// ************************************************************************* //
