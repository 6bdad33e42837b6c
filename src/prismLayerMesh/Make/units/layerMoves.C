/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerMoves/columnStates.C"
#include "layerMoves/layerEditor.C"
#include "layerMoves/layerEditorRecord.C"
#include "layerMoves/retreatColumns.C"
#include "layerMoves/turnColumns.C"
#include "layerMoves/leanColumns.C"
#include "layerMoves/linearColumnCells.C"
#include "layerMoves/bendTargets.C"
#include "layerMoves/columnCells.C"
#include "layerMoves/columnColours.C"
#include "layerMoves/bendColumns.C"
#include "layerMoves/growColumns.C"
#include "layerMoves/faultRollBack.C"
#include "layerMoves/fittedWall.C"
#include "layerMoves/heightFit.C"
#include "layerMoves/displaceColumns.C"
#include "layerMoves/fitHeights.C"
#include "layerMoves/heightLimits.C"
#include "layerMoves/limitHeightJumps.C"
#include "layerMoves/columnsInTheWay.C"
#include "layerMoves/certifyLayers.C"
#include "layerMoves/improveLayers.C"
#include "layerMoves/makePrismLayers.C"
#include "layerMoves/nameCauses.C"

// ************************************************************************* //
