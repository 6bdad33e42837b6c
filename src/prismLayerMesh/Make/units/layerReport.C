/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerReport/faceHeights.C"
#include "layerReport/percentiles.C"
#include "layerReport/patchReport.C"
#include "layerReport/layerReport.C"
#include "layerReport/stageLog.C"
#include "layerReport/layerReportIO.C"
#include "layerReport/layerReportTable.C"
#include "layerReport/faceQualityReport.C"
#include "layerReport/farFieldReport.C"
#include "layerReport/levelSetReport.C"
#include "layerReport/writeVtk.C"
#include "layerReport/paraviewScript.C"
#include "layerReport/writeStageFields.C"

// ************************************************************************* //
