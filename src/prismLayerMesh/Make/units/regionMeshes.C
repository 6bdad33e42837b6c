/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionMeshes/regionMeshes.C"
#include "regionMeshes/closeRegion.C"
#include "regionMeshes/regionPolygons.C"

// ************************************************************************* //
