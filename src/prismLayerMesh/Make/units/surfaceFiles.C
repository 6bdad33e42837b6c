/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceFiles/surfaceFormats.C"
#include "surfaceFiles/surfaceFile.C"
#include "surfaceFiles/mergeNearPoints.C"
#include "surfaceFiles/orientWallSurface.C"
#include "surfaceFiles/readWallSurface.C"

// ************************************************************************* //
