/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "throwingErrors.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(throwingErrors, restoresWhatWasBefore)
{
    for (const bool before : {false, true})
    {
        const bool error = FatalError.throwExceptions(before);
        const bool ioError = FatalIOError.throwExceptions(before);

        {
            const throwingErrors throwing;
            EXPECT_TRUE(FatalError.throwing());
            EXPECT_EQ(FatalIOError.throwing(), before);

            {
                const throwingErrors both(true);
                EXPECT_TRUE(FatalError.throwing());
                EXPECT_TRUE(FatalIOError.throwing());
            }

            EXPECT_TRUE(FatalError.throwing());
            EXPECT_EQ(FatalIOError.throwing(), before);
        }

        EXPECT_EQ(FatalError.throwing(), before);
        EXPECT_EQ(FatalIOError.throwing(), before);

        FatalError.throwExceptions(error);
        FatalIOError.throwExceptions(ioError);
    }
}


// ************************************************************************* //
