/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerControls/controlEntriesTest.C"
#include "prismLayerControls/readLayerHeightsTest.C"
#include "prismLayerControls/readLayerControlsTest.C"
#include "prismLayerControls/yPlusRunTest.C"
#include "prismLayerControls/sidePlanesTest.C"
#include "prismLayerControls/surfaceRepairTest.C"
#include "prismLayerControls/surfaceCadTest.C"
#include "prismLayerControls/surfaceRemeshTest.C"
#include "prismLayerControls/qualityTest.C"
#include "prismLayerControls/prismLayerControlsTest.C"
#include "prismLayerControls/readFarFieldControlsTest.C"
#include "prismLayerControls/annotatedDictTest.C"
#include "prismLayerControls/pluginVersionTest.C"
#include "prismLayerControls/sidePatchTest.C"

// ************************************************************************* //
