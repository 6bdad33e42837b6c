/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerFront/columnConstraint.C"
#include "layerFront/sectorSearch.C"
#include "layerFront/planarFan.C"
#include "layerFront/normalSectors.C"
#include "layerFront/faceSectors.C"
#include "layerFront/layerFront.C"

// ************************************************************************* //
