/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerColumns/gradientLinesTest.C"
#include "layerColumns/blockLinesTest.C"
#include "layerColumns/sharedBlocksTest.C"
#include "layerColumns/wallBlocksTest.C"
#include "layerColumns/straightSharesTest.C"
#include "layerColumns/layerColumnsTest.C"
#include "layerColumns/levelSetsTest.C"
#include "layerColumns/wallSmootherTest.C"

// ************************************************************************* //
