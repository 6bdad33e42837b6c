/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "spaceRegions/spaceParts.C"
#include "spaceRegions/contacts.C"
#include "spaceRegions/spaceRegions.C"
#include "spaceRegions/leakPath.C"

// ************************************************************************* //
