/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismQuality/isPositive.C"
#include "prismQuality/prismQuality.C"
#include "prismQuality/cellGeometry.C"
#include "prismQuality/layerGeometry.C"
#include "prismQuality/faceQualityCounts.C"
#include "prismQuality/facePyramids.C"
#include "prismQuality/stackBoxes.C"
#include "prismQuality/stackHeights.C"
#include "prismQuality/nestedBodies.C"
#include "prismQuality/stackExchange.C"
#include "prismQuality/layerOverlaps.C"
#include "prismQuality/partCrossings.C"
#include "prismQuality/sideCrossings.C"
#include "prismQuality/prismIntersections.C"
#include "prismQuality/scaledJacobian.C"
#include "prismQuality/layerJudge.C"

// ************************************************************************* //
