/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMeshFuzz.C"
#include "fuzzTally.C"
#include "fuzzCase.C"
#include "makeFuzzCase.C"
#include "writeFuzzCase.C"
#include "fuzzWall.C"
#include "meshFuzzCase.C"
#include "meshFaults.C"
#include "fuzzFarField.C"
#include "surroundingMesh.C"
#include "meshFarField.C"
#include "farFieldFaults.C"
#include "domainFaults.C"
#include "planeDomain.C"
#include "coneVolume.C"
#include "embeddingFault.C"
#include "randomSurface.C"
#include "perturbedSphere.C"
#include "boxUnion.C"
#include "spikyPolyhedron.C"
#include "convexHull.C"
#include "starPrism.C"
#include "severalBodies.C"
#include "cutBody.C"
#include "bodiesAtSides.C"
#include "periodicBody.C"
#include "cyclicFaults.C"
#include "curvedEnds.C"
#include "assembly.C"
#include "meshRegions.C"
#include "damageSurface.C"
#include "addNeedles.C"

// ************************************************************************* //
