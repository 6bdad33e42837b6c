/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fuzz/meshFaultsTest.C"
#include "fuzz/planeDomainTest.C"
#include "fuzz/farFieldFaultsTest.C"
#include "fuzz/fuzzWallTest.C"

// ************************************************************************* //
