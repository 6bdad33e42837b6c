/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prepareWall/fluidSideTest.C"
#include "prepareWall/prepareWallTest.C"
#include "prepareWall/wallAccountTest.C"

// ************************************************************************* //
