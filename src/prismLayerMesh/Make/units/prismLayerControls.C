/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerControls/controlEntries.C"
#include "prismLayerControls/heightSeries.C"
#include "prismLayerControls/readLayerControls.C"
#include "prismLayerControls/readControls.C"
#include "prismLayerControls/pluginVersion.C"

// ************************************************************************* //
