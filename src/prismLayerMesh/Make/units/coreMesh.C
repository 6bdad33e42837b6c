/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreMesh/splitPolygon.C"
#include "coreMesh/hexOctree.C"
#include "coreMesh/hexPoints.C"
#include "coreMesh/hexFaces.C"
#include "coreMesh/makeHexCore.C"
#include "coreMesh/corePlanes.C"
#include "coreMesh/patchesOnWall.C"
#include "coreMesh/stayingCells.C"
#include "coreMesh/coupledPatches.C"
#include "coreMesh/planeOutlines.C"
#include "coreMesh/cutCore.C"
#include "coreMesh/roomParts.C"
#include "coreMesh/overlappingCells.C"
#include "coreMesh/partsOfMesh.C"

// ************************************************************************* //
