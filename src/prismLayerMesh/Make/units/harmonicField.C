/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicField/fieldGradients.C"
#include "harmonicField/harmonicField.C"
#include "harmonicField/monotoneField.C"
#include "harmonicField/criticalPoints.C"

// ************************************************************************* //
