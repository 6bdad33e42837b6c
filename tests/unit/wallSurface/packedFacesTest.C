/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "packedFaces.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(packedFaces, listsOfMixedFaces)
{
    const packedFaces packed(faceList{face{4, 2, 0}, face{7, 5, 3, 1}});

    EXPECT_EQ(packed.sizes, (labelList{3, 4}));
    EXPECT_EQ(packed.corners, (labelList{4, 2, 0, 7, 5, 3, 1}));
}


TEST(packedFaces, unpackGivesTheFacesBack)
{
    const faceList faces{face{4, 2, 0}, face{7, 5, 3, 1}};

    EXPECT_EQ(packedFaces(faces).unpacked(), faces);
    EXPECT_TRUE(packedFaces(faceList()).unpacked().empty());
}


// ************************************************************************* //
