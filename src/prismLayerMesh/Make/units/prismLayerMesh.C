/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMesh/readPrismLayerControls.C"
#include "prismLayerMesh/readRegionControls.C"
#include "prismLayerMesh/domainStages.C"
#include "prismLayerMesh/regionStages.C"
#include "prismLayerMesh/stageText.C"
#include "prismLayerMesh/wallPointsError.C"
#include "prismLayerMesh/fieldStages.C"
#include "prismLayerMesh/columnGuide.C"
#include "prismLayerMesh/layerStages.C"
#include "prismLayerMesh/periodicStages.C"
#include "prismLayerMesh/gatherShares.C"
#include "prismLayerMesh/prismLayerMesh.C"
#include "prismLayerMesh/meshPlan.C"

// ************************************************************************* //
