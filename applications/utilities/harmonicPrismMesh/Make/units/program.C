/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "replacedFiles.C"
#include "readWall.C"
#include "readDomain.C"
#include "layerSurfaces.C"
#include "prismCase.C"
#include "caseWriter.C"
#include "writeCase.C"
#include "hostThreads.C"
#include "pstreamTeam.C"
#include "caseLayers.C"
#include "parallelRun.C"
#include "meshWall.C"
#include "harmonicPrismMesh.C"

// ************************************************************************* //
