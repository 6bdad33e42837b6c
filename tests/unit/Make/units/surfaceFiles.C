/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceFiles/writeObjTest.C"
#include "surfaceFiles/readWallSurfaceTest.C"
#include "surfaceFiles/curveFileTest.C"
#include "surfaceFiles/curveEndsTest.C"
#include "surfaceFiles/mergeNearPointsTest.C"
#include "surfaceFiles/severalFilesTest.C"
#include "surfaceFiles/orientWallSurfaceTest.C"
#include "surfaceFiles/brokenSurfaceFilesTest.C"

// ************************************************************************* //
