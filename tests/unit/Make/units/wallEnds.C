/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallEnds/convexPolyhedronTest.C"
#include "wallEnds/boxSidesTest.C"
#include "wallEnds/periodicWallTest.C"
#include "wallEnds/planesOfBorderTest.C"
#include "wallEnds/sideBordersTest.C"
#include "wallEnds/sideFacesTest.C"
#include "wallEnds/sidePartsTest.C"
#include "wallEnds/openComponentsTest.C"
#include "wallEnds/orientOpenWallTest.C"
#include "wallEnds/splitAtEdgesTest.C"
#include "wallEnds/splitAtSidePatchesTest.C"
#include "wallEnds/splitAtSidePatchesErrorsTest.C"

// ************************************************************************* //
