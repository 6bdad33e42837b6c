/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldMesh/farFieldMesh.C"
#include "farFieldMesh/boundaryTets.C"
#include "farFieldMesh/coreCellZones.C"
#include "farFieldMesh/coreFaceZones.C"
#include "farFieldMesh/cellSizes.C"
#include "farFieldMesh/makeSizeBounds.C"
#include "farFieldMesh/improveTriangles.C"
#include "farFieldMesh/planePoints.C"
#include "farFieldMesh/layerBorder.C"
#include "farFieldMesh/sideRegions.C"
#include "farFieldMesh/planeRemainders.C"
#include "farFieldMesh/sidePatchRemainders.C"
#include "farFieldMesh/refineSurface.C"
#include "farFieldMesh/outerTriangles.C"
#include "farFieldMesh/farBoundary.C"
#include "farFieldMesh/checkFarBoundary.C"
#include "farFieldMesh/coarsenCuts.C"
#include "farFieldMesh/splitCornerCells.C"
#include "farFieldMesh/fillWithTets.C"
#include "farFieldMesh/improveTets.C"
#include "farFieldMesh/tetViolation.C"
#include "farFieldMesh/tetImprover.C"
#include "farFieldMesh/tetImproverMoves.C"
#include "farFieldMesh/tetBoundary.C"
#include "farFieldMesh/coreBox.C"
#include "farFieldMesh/coreBoundary.C"
#include "farFieldMesh/joinCells.C"
#include "farFieldMesh/coreNotes.C"
#include "farFieldMesh/farFieldSizes.C"
#include "farFieldMesh/makeFarFieldMesh.C"

// ************************************************************************* //
