/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh/prismFaces.C"
#include "prismPolyMesh/meshBlocks.C"
#include "prismPolyMesh/meshPiece.C"
#include "prismPolyMesh/meshOrder.C"
#include "prismPolyMesh/meshFiles.C"
#include "prismPolyMesh/prismPolyMesh.C"
#include "prismPolyMesh/wedgeMesh.C"
#include "prismPolyMesh/divideMesh.C"

// ************************************************************************* //
