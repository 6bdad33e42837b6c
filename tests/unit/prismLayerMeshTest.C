/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

Application
    prismLayerMeshTest

Description
    The unit tests, one file per source in a tree like that of the sources.
    OpenFOAM's fatal errors are exceptions here, so that EXPECT_THROW sees
    them.

\*---------------------------------------------------------------------------*/

#include "error.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    testing::InitGoogleTest(&argc, argv);

    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();

    return RUN_ALL_TESTS();
}


// ************************************************************************* //
