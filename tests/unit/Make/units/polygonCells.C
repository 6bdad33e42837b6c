/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonCells/commonWallTest.C"
#include "polygonCells/cyclicFacesTest.C"
#include "polygonCells/outlinesTest.C"
#include "polygonCells/groupExceptionsTest.C"
#include "polygonCells/keptPartsTest.C"
#include "polygonCells/layerPolygonsTest.C"
#include "polygonCells/changedPartTest.C"
#include "polygonCells/polygonCellsTest.C"

// ************************************************************************* //
