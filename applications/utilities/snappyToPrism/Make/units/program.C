/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "blockBox.C"
#include "snappyWalls.C"
#include "snappyCase.C"
#include "layerEntries.C"
#include "prismEntries.C"
#include "snappyToPrism.C"

// ************************************************************************* //
