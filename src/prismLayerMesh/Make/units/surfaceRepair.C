/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRepair/nearestSurface.C"
#include "surfaceRepair/stitchFaces.C"
#include "surfaceRepair/closeGaps.C"
#include "surfaceRepair/dividedTriangles.C"
#include "surfaceRepair/unionBoundary.C"
#include "surfaceRepair/unions.C"
#include "surfaceRepair/removeSlivers.C"
#include "surfaceRepair/soundBody.C"
#include "surfaceRepair/joinBodies.C"
#include "surfaceRepair/wrapSurface.C"
#include "surfaceRepair/waysOnSurface.C"
#include "surfaceRepair/cutSurface.C"
#include "surfaceRepair/wrapTargets.C"
#include "surfaceRepair/snapToSurface.C"
#include "surfaceRepair/stitchSurface.C"
#include "surfaceRepair/repairSurface.C"

// ************************************************************************* //
