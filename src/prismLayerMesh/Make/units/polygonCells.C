/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonCells/commonWall.C"
#include "polygonCells/cyclicFaces.C"
#include "polygonCells/outlines.C"
#include "polygonCells/farTets.C"
#include "polygonCells/innerWeights.C"
#include "polygonCells/cornerPoints.C"
#include "polygonCells/polygonFaces.C"
#include "polygonCells/groupExceptions.C"
#include "polygonCells/changedPart.C"
#include "polygonCells/layerPolygons.C"
#include "polygonCells/wallPolygons.C"
#include "polygonCells/farGroups.C"
#include "polygonCells/farPolygons.C"
#include "polygonCells/divideGroups.C"
#include "polygonCells/polygonGeometry.C"
#include "polygonCells/polygonGrade.C"
#include "polygonCells/polygonPoorness.C"
#include "polygonCells/movePolygonPoints.C"
#include "polygonCells/keptParts.C"
#include "polygonCells/polygonPatches.C"
#include "polygonCells/polygonMaker.C"
#include "polygonCells/polygonCells.C"

// ************************************************************************* //
