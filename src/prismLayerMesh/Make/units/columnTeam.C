/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnTeam/processTeam.C"
#include "columnTeam/pstreamTeam.C"
#include "columnTeam/frontPart.C"
#include "columnTeam/frontShare.C"
#include "columnTeam/periodicShare.C"
#include "columnTeam/distributeFront.C"
#include "columnTeam/columnTeam.C"

// ************************************************************************* //
