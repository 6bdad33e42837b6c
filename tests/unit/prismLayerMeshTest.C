/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
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
