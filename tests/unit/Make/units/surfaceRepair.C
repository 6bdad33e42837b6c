/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRepair/exactUnionTest.C"
#include "surfaceRepair/snapBordersTest.C"
#include "surfaceRepair/stitchSurfaceTest.C"
#include "surfaceRepair/nearestSurfaceTest.C"
#include "surfaceRepair/removeSliversTest.C"
#include "surfaceRepair/cutSurfaceTest.C"
#include "surfaceRepair/wrapShapeTest.C"
#include "surfaceRepair/wrapSurfaceTest.C"
#include "surfaceRepair/soundSurfaceTest.C"
#include "surfaceRepair/repairSurfaceTest.C"

// ************************************************************************* //
