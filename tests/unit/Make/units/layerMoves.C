/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerMoves/heightFitTest.C"
#include "layerMoves/heightLimitsTest.C"
#include "layerMoves/columnConstraintTest.C"
#include "layerMoves/layerEditorTest.C"
#include "layerMoves/orderOfMovesTest.C"
#include "layerMoves/retreatColumnsTest.C"
#include "layerMoves/turnColumnsTest.C"
#include "layerMoves/leanColumnsTest.C"
#include "layerMoves/bendColumnsTest.C"
#include "layerMoves/columnCellsTest.C"
#include "layerMoves/columnColoursTest.C"
#include "layerMoves/giveWayTest.C"
#include "layerMoves/growColumnsTest.C"
#include "layerMoves/fitHeightsTest.C"
#include "layerMoves/limitHeightJumpsTest.C"
#include "layerMoves/improveLayersTest.C"
#include "layerMoves/nameCausesTest.C"
#include "layerMoves/makePrismLayersTest.C"

// ************************************************************************* //
