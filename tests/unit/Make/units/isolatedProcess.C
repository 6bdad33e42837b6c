/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "isolatedProcess/isolatedProcessTest.C"
#include "isolatedProcess/messageTest.C"
#include "isolatedProcess/stageProgressTest.C"
#include "isolatedProcess/runProgramTest.C"
#include "isolatedProcess/throwingErrorsTest.C"

// ************************************************************************* //
