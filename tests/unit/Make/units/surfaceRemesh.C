/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRemesh/edgeBoundsTest.C"
#include "surfaceRemesh/givenSurfaceTest.C"
#include "surfaceRemesh/remeshQualityTest.C"
#include "surfaceRemesh/remeshSurfaceTest.C"
#include "surfaceRemesh/remesherTest.C"
#include "surfaceRemesh/refineSurfaceTest.C"
#include "surfaceRemesh/surfaceChangesTest.C"

// ************************************************************************* //
