/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismQuality/prismQualityTest.C"
#include "prismQuality/scaledJacobianTest.C"
#include "prismQuality/layerJudgeTest.C"
#include "prismQuality/collapsedCellsTest.C"
#include "prismQuality/facePyramidsTest.C"
#include "prismQuality/nestedBodiesTest.C"
#include "prismQuality/prismIntersectionsTest.C"
#include "prismQuality/sideCrossingsTest.C"
#include "prismQuality/stackBoxesTest.C"
#include "prismQuality/stackHeightsTest.C"
#include "prismQuality/layerGeometryTest.C"
#include "prismQuality/faceQualityCountsTest.C"

// ************************************************************************* //
