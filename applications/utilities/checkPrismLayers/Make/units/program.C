/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "certificateLog.C"
#include "layeredWalls.C"
#include "patchOptions.C"
#include "plainScheme.C"
#include "checkPrismLayers.C"

// ************************************************************************* //
