/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh/prismPolyMeshTest.C"
#include "prismPolyMesh/meshFilesTest.C"
#include "prismPolyMesh/meshPieceTest.C"
#include "prismPolyMesh/writeBlocksTest.C"
#include "prismPolyMesh/divideMeshTest.C"
#include "prismPolyMesh/multipleNormalsMeshTest.C"
#include "prismPolyMesh/cyclicMeshTest.C"
#include "prismPolyMesh/endedMeshTest.C"
#include "prismPolyMesh/wedgeMeshTest.C"

// ************************************************************************* //
