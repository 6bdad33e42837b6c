/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldMesh/coreFaceZonesTest.C"
#include "farFieldMesh/coreFarFieldTest.C"
#include "farFieldMesh/cellSizesTest.C"
#include "farFieldMesh/coarsenCutsTest.C"
#include "farFieldMesh/replacedPatchesTest.C"
#include "farFieldMesh/expectedFarFieldTest.C"
#include "farFieldMesh/farBoundaryTest.C"
#include "farFieldMesh/outerTrianglesTest.C"
#include "farFieldMesh/layerBorderTest.C"
#include "farFieldMesh/sidePatchRemaindersTest.C"
#include "farFieldMesh/farFieldTetsTest.C"
#include "farFieldMesh/improveTetsTest.C"
#include "farFieldMesh/tetPatchTest.C"
#include "farFieldMesh/makeFarFieldMeshTest.C"
#include "farFieldMesh/mergeCellsTest.C"
#include "farFieldMesh/packPointsTest.C"
#include "farFieldMesh/mergingMeshTest.C"
#include "farFieldMesh/curvedSidesTest.C"
#include "farFieldMesh/endedFarFieldTest.C"

// ************************************************************************* //
