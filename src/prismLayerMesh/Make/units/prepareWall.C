/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prepareWall/fluidSide.C"
#include "prepareWall/givenParts.C"
#include "prepareWall/hidingParts.C"
#include "prepareWall/wallAccount.C"
#include "prepareWall/prepareWall.C"
#include "prepareWall/prepareRegion.C"
#include "prepareWall/surfaceAdvice.C"

// ************************************************************************* //
