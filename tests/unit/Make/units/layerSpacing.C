/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerSpacing/layerSpacingTest.C"
#include "layerSpacing/givenHeightsTest.C"
#include "layerSpacing/makeLayerSpacingTest.C"
#include "layerSpacing/limitGradientTest.C"
#include "layerSpacing/expectedYPlusTest.C"

// ************************************************************************* //
