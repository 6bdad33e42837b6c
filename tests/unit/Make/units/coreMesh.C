/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coreMesh/splitPolygonTest.C"
#include "coreMesh/hexPointsTest.C"
#include "coreMesh/makeHexCoreTest.C"
#include "coreMesh/planeOutlinesTest.C"
#include "coreMesh/cutCoreTest.C"
#include "coreMesh/periodicCoreTest.C"
#include "coreMesh/stayingCellsTest.C"
#include "coreMesh/partsOfMeshTest.C"

// ************************************************************************* //
