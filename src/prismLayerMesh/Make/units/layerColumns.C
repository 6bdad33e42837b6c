/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerColumns/gradientLines.C"
#include "layerColumns/columnLines.C"
#include "layerColumns/blockLines.C"
#include "layerColumns/wallBlocks.C"
#include "layerColumns/sharedBlocks.C"
#include "layerColumns/straightShares.C"
#include "layerColumns/wallSmoother.C"
#include "layerColumns/layerColumns.C"
#include "layerColumns/makeLayerColumns.C"
#include "layerColumns/levelSets.C"

// ************************************************************************* //
