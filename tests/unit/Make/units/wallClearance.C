/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallClearance/wallClearanceTest.C"
#include "wallClearance/wallSearchTest.C"
#include "wallClearance/triangleTreeTest.C"
#include "wallClearance/sideSearchTest.C"
#include "wallClearance/mirrorImagesTest.C"

// ************************************************************************* //
