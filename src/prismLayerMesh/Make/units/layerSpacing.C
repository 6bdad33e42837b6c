/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerSpacing/limitGradient.C"
#include "layerSpacing/layerSpacing.C"
#include "layerSpacing/expectedYPlus.C"

// ************************************************************************* //
