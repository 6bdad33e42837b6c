/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismQuality/prismQuality.C"
#include "prismQuality/layerGeometry.C"
#include "prismQuality/faceQualityCounts.C"
#include "prismQuality/layerOverlaps.C"
#include "prismQuality/sideCrossings.C"
#include "prismQuality/scaledJacobian.C"
#include "prismQuality/layerJudge.C"

// ************************************************************************* //
