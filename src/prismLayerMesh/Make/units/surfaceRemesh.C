/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRemesh/givenSurface.C"
#include "surfaceRemesh/givenLines.C"
#include "surfaceRemesh/nearGiven.C"
#include "surfaceRemesh/changeJournal.C"
#include "surfaceRemesh/editedSurface.C"
#include "surfaceRemesh/editedSurfaceChanges.C"
#include "surfaceRemesh/splitEdge.C"
#include "surfaceRemesh/collapseEdge.C"
#include "surfaceRemesh/flipEdge.C"
#include "surfaceRemesh/moveVertex.C"
#include "surfaceRemesh/changeGuard.C"
#include "surfaceRemesh/changeGuardReplace.C"
#include "surfaceRemesh/remeshQuality.C"
#include "surfaceRemesh/edgeBounds.C"
#include "surfaceRemesh/remesher.C"
#include "surfaceRemesh/remeshFaults.C"
#include "surfaceRemesh/remeshSurface.C"

// ************************************************************************* //
