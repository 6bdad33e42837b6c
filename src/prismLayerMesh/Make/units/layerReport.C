/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerReport/patchReport.C"
#include "layerReport/layerReport.C"
#include "layerReport/layerReportIO.C"
#include "layerReport/stageLog.C"
#include "layerReport/farFieldReport.C"
#include "layerReport/surfaceReport.C"
#include "layerReport/polygonReport.C"
#include "layerReport/meshVerdict.C"
#include "layerReport/writeJson.C"
#include "layerReport/replacedFiles.C"
#include "layerReport/refusal.C"
#include "layerReport/fieldNames.C"
#include "layerReport/levelSetReport.C"
#include "layerReport/writeVtk.C"
#include "layerReport/writeStageFields.C"

// ************************************************************************* //
