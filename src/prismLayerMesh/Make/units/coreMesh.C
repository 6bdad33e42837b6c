/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreMesh/planeOutlines.C"
#include "coreMesh/hexOctree.C"
#include "coreMesh/makeHexCore.C"
#include "coreMesh/periodicCore.C"
#include "coreMesh/stayingCells.C"
#include "coreMesh/cutCore.C"
#include "coreMesh/partsOfMesh.C"

// ************************************************************************* //
