/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testSurfaces/testSurfaces.C"
#include "testSurfaces/openSurfaces.C"
#include "testSurfaces/flatMesh.C"
#include "testSurfaces/extruded.C"
#include "testSurfaces/corners.C"
#include "testSurfaces/renumbered.C"
#include "testSurfaces/saddles.C"
#include "testSurfaces/testSurfacesTest.C"
#include "testSurfaces/testLayers.C"
#include "testSurfaces/testStages.C"
#include "testSurfaces/testMeshes.C"

// ************************************************************************* //
