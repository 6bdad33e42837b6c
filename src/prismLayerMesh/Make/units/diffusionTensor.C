/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusionTensor/diffusionTensor.C"
#include "diffusionTensor/isotropicDiffusionTensor.C"
#include "diffusionTensor/anisotropicDiffusionTensor.C"
#include "diffusionTensor/gradientPowerDiffusionTensor.C"
#include "diffusionTensor/localConductivity.C"

// ************************************************************************* //
