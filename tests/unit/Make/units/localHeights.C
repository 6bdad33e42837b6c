/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localHeights/regionSearchTest.C"
#include "localHeights/surfaceValuesTest.C"
#include "localHeights/readLocalHeightsTest.C"
#include "localHeights/yPlusHeightsTest.C"
#include "localHeights/earlierRunTest.C"

// ************************************************************************* //
