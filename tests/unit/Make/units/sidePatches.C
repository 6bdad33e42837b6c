/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatches/outlineTest.C"
#include "sidePatches/sidePairTest.C"
#include "sidePatches/sideShapeTest.C"

// ************************************************************************* //
