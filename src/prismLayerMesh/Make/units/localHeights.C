/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localHeights/regionSearch.C"
#include "localHeights/earlierRun.C"
#include "localHeights/yPlusHeights.C"
#include "localHeights/readLocalHeights.C"

// ************************************************************************* //
