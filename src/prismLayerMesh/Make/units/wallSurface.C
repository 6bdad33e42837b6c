/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurface/wallSurface.C"
#include "wallSurface/surfaceMeasures.C"
#include "wallSurface/wallChanges.C"
#include "wallSurface/surfacePart.C"
#include "wallSurface/renumberWall.C"
#include "wallSurface/wallPredicates.C"

// ************************************************************************* //
