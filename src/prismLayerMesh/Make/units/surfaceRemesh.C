/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRemesh/givenSurface.C"
#include "surfaceRemesh/changeGuard.C"
#include "surfaceRemesh/editedSurface.C"
#include "surfaceRemesh/surfaceChanges.C"
#include "surfaceRemesh/remeshQuality.C"
#include "surfaceRemesh/remesher.C"
#include "surfaceRemesh/edgeBounds.C"
#include "surfaceRemesh/refineSurface.C"
#include "surfaceRemesh/remeshSurface.C"

// ************************************************************************* //
