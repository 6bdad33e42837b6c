/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRepair/nearestSurface.C"
#include "surfaceRepair/stitchFaces.C"
#include "surfaceRepair/borderContacts.C"
#include "surfaceRepair/snapBorders.C"
#include "surfaceRepair/closeGaps.C"
#include "surfaceRepair/divideTriangles.C"
#include "surfaceRepair/windingNumber.C"
#include "surfaceRepair/unionBoundary.C"
#include "surfaceRepair/exactUnion.C"
#include "surfaceRepair/fillContacts.C"
#include "surfaceRepair/removeSlivers.C"
#include "surfaceRepair/soundBody.C"
#include "surfaceRepair/joinBodies.C"
#include "surfaceRepair/uniteBodies.C"
#include "surfaceRepair/wrapSurface.C"
#include "surfaceRepair/cutSurface.C"
#include "surfaceRepair/sharpLines.C"
#include "surfaceRepair/chamfers.C"
#include "surfaceRepair/wrapTargets.C"
#include "surfaceRepair/wrapShape.C"
#include "surfaceRepair/snapToSurface.C"
#include "surfaceRepair/wrapLeaks.C"
#include "surfaceRepair/soundSurface.C"
#include "surfaceRepair/stitchSurface.C"
#include "surfaceRepair/repairSurface.C"

// ************************************************************************* //
