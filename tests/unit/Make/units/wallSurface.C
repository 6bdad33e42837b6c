/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurface/cutReflexFacesTest.C"
#include "wallSurface/flipCapsTest.C"
#include "wallSurface/renumberWallTest.C"
#include "wallSurface/surfacePartTest.C"
#include "wallSurface/wallSurfaceTest.C"
#include "wallSurface/surfaceMeasuresTest.C"
#include "wallSurface/openAddressingTest.C"

// ************************************************************************* //
