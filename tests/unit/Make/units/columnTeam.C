/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnTeam/pointOwnersTest.C"
#include "columnTeam/frontShareTest.C"
#include "columnTeam/distributeFrontTest.C"
#include "columnTeam/failuresInTeamTest.C"
#include "columnTeam/columnTeamTest.C"
#include "columnTeam/layersOnSharesTest.C"

// ************************************************************************* //
