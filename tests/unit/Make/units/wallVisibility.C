/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallVisibility/visibilityConeTest.C"
#include "wallVisibility/wallVisibilityTest.C"
#include "wallVisibility/sideConesTest.C"
#include "wallVisibility/cutBlindFacesTest.C"
#include "wallVisibility/pointKindTest.C"
#include "wallVisibility/inwardCurvatureTest.C"

// ************************************************************************* //
