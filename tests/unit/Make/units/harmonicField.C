/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicField/harmonicFieldTest.C"
#include "harmonicField/pointGradientMeansTest.C"
#include "harmonicField/closedFormsTest.C"
#include "harmonicField/criticalPointsTest.C"

// ************************************************************************* //
