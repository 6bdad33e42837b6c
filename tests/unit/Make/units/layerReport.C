/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerReport/layerReportTest.C"
#include "layerReport/stageLogTest.C"
#include "layerReport/levelSetEvennessTest.C"
#include "layerReport/faceHeightsTest.C"
#include "layerReport/writeVtkTest.C"
#include "layerReport/polygonReportTest.C"
#include "layerReport/meshVerdictTest.C"
#include "layerReport/writeJsonTest.C"
#include "layerReport/refusalTest.C"
#include "layerReport/fieldNamesTest.C"

// ************************************************************************* //
