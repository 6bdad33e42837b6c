/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallEnds/boxSides.C"
#include "wallEnds/divideSidePart.C"
#include "wallEnds/flushSides.C"
#include "wallEnds/orientOpenWall.C"
#include "wallEnds/sideParts.C"
#include "wallEnds/splitAtSidePatches.C"
#include "wallEnds/cyclicSides.C"
#include "wallEnds/periodicWall.C"
#include "wallEnds/planesOfBorder.C"
#include "wallEnds/convexPolyhedron.C"

// ************************************************************************* //
