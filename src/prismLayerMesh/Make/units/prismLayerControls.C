/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerControls/controlEntries.C"
#include "prismLayerControls/geometricHeights.C"
#include "prismLayerControls/heightSeries.C"
#include "prismLayerControls/readLayerHeights.C"
#include "prismLayerControls/readRegions.C"
#include "prismLayerControls/readLayerParts.C"
#include "prismLayerControls/readRemeshControls.C"
#include "prismLayerControls/readLayerControls.C"
#include "prismLayerControls/readFarFieldControls.C"
#include "prismLayerControls/pluginVersion.C"

// ************************************************************************* //
