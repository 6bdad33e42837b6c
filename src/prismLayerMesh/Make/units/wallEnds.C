/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallEnds/divideSidePart.C"
#include "wallEnds/openComponents.C"
#include "wallEnds/orientOpenWall.C"
#include "wallEnds/sideFaces.C"
#include "wallEnds/sideParts.C"
#include "wallEnds/checkInFront.C"
#include "wallEnds/sideBorders.C"
#include "wallEnds/splitAtEdges.C"
#include "wallEnds/splitAtSidePatches.C"
#include "wallEnds/boxSidePlanes.C"
#include "wallEnds/planesOfBorder.C"
#include "wallEnds/convexPolyhedron.C"

// ************************************************************************* //
