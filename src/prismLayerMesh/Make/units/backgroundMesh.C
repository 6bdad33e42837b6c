/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "backgroundMesh/fieldBlock.C"
#include "backgroundMesh/wallDomain.C"
#include "backgroundMesh/wallBridges.C"
#include "backgroundMesh/backgroundMesh.C"
#include "backgroundMesh/levelSetTopology.C"

// ************************************************************************* //
