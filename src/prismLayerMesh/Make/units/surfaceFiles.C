/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceFiles/surfaceFile.C"
#include "surfaceFiles/curveFile.C"
#include "surfaceFiles/curveEnds.C"
#include "surfaceFiles/planarWall.C"
#include "surfaceFiles/readWallSurface.C"
#include "surfaceFiles/writeObj.C"

// ************************************************************************* //
