/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusionTensor/diffusionTensorTest.C"
#include "diffusionTensor/gradientPowerTensorTest.C"
#include "diffusionTensor/patchTest.C"
#include "diffusionTensor/localConductivityTest.C"

// ************************************************************************* //
