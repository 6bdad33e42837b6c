/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isolatedProcess/guardedReading.C"
#include "isolatedProcess/isolatedProcess.C"
#include "isolatedProcess/stageProgress.C"
#include "isolatedProcess/returnMemory.C"
#include "isolatedProcess/runProgram.C"
#include "isolatedProcess/scratchFolder.C"
#include "isolatedProcess/waitPassively.C"

// ************************************************************************* //
