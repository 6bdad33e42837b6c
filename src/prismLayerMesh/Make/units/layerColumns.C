/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerColumns/gradientLines.C"
#include "layerColumns/columnLines.C"
#include "layerColumns/wallBlocks.C"
#include "layerColumns/layerColumns.C"
#include "layerColumns/wallSmoother.C"
#include "layerColumns/levelSets.C"

// ************************************************************************* //
