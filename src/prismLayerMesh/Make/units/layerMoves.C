/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerMoves/layerEditor.C"
#include "layerMoves/retreatColumns.C"
#include "layerMoves/leanColumns.C"
#include "layerMoves/columnStack.C"
#include "layerMoves/columnCells.C"
#include "layerMoves/bendColumns.C"
#include "layerMoves/improveLayers.C"
#include "layerMoves/heightFit.C"
#include "layerMoves/fitHeights.C"
#include "layerMoves/limitHeightJumps.C"
#include "layerMoves/certifyLayers.C"
#include "layerMoves/makePrismLayers.C"

// ************************************************************************* //
