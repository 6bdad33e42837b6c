/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismPolyMesh/findFaceNeighbours.C"
#include "prismPolyMesh/prismFaces.C"
#include "prismPolyMesh/prismFaceLabels.C"
#include "prismPolyMesh/prismTopology.C"
#include "prismPolyMesh/meshBlocks.C"
#include "prismPolyMesh/meshOrder.C"
#include "prismPolyMesh/writeBlocks.C"
#include "prismPolyMesh/meshFiles.C"
#include "prismPolyMesh/prismPatches.C"
#include "prismPolyMesh/prismPolyMesh.C"
#include "prismPolyMesh/meshPiece.C"
#include "prismPolyMesh/layersDivider.C"
#include "prismPolyMesh/assemblePiece.C"
#include "prismPolyMesh/layerBlocks.C"
#include "prismPolyMesh/sidesBetween.C"
#include "prismPolyMesh/pieceOrder.C"
#include "prismPolyMesh/writeMeshPiece.C"
#include "prismPolyMesh/sharedPiece.C"

// ************************************************************************* //
