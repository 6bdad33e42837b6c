/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runOptions.C"
#include "refuseRun.C"
#include "prismCase.C"
#include "readWall.C"
#include "meshWall.C"
#include "planWall.C"
#include "caseWriter.C"
#include "parallelRun.C"
#include "caseLayers.C"
#include "meshRegions.C"
#include "harmonicPrismMesh.C"

// ************************************************************************* //
