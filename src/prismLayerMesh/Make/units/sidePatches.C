/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatches/sideCurve.C"
#include "sidePatches/sidePatch.C"
#include "sidePatches/sideShape.C"

// ************************************************************************* //
