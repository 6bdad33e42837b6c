/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldMesh/farFieldMesh.C"
#include "farFieldMesh/farFieldTets.C"
#include "farFieldMesh/packPoints.C"
#include "farFieldMesh/coreZones.C"
#include "farFieldMesh/cellSizes.C"
#include "farFieldMesh/replacedPatches.C"
#include "farFieldMesh/sideRegions.C"
#include "farFieldMesh/sidePatchRemainders.C"
#include "farFieldMesh/tetBoundary.C"
#include "farFieldMesh/farBoundary.C"
#include "farFieldMesh/improveTets.C"
#include "farFieldMesh/tetViolation.C"
#include "farFieldMesh/tetPatch.C"
#include "farFieldMesh/tetImprover.C"
#include "farFieldMesh/coreBoundary.C"
#include "farFieldMesh/mergingMesh.C"
#include "farFieldMesh/mergeCells.C"
#include "farFieldMesh/planarFarField.C"
#include "farFieldMesh/joinCells.C"
#include "farFieldMesh/makeFarFieldMesh.C"
#include "farFieldMesh/farFieldSizes.C"
#include "farFieldMesh/expectedFarField.C"

// ************************************************************************* //
