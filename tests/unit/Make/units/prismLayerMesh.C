/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMesh/adviceOnPointsTest.C"
#include "prismLayerMesh/periodicLayersTest.C"
#include "prismLayerMesh/meshPlanTest.C"
#include "prismLayerMesh/makePrismLayerMeshTest.C"

// ************************************************************************* //
