/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerFront/normalSectorsTest.C"
#include "layerFront/planarFanTest.C"
#include "layerFront/faceSectorsTest.C"
#include "layerFront/layerFrontTest.C"

// ************************************************************************* //
