/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isolatedProcess/throwingErrors.C"
#include "isolatedProcess/isolatedProcess.C"
#include "isolatedProcess/stageProgress.C"
#include "isolatedProcess/returnMemory.C"

// ************************************************************************* //
