/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallVisibility/visibilityCone.C"
#include "wallVisibility/makeWallVisibility.C"
#include "wallVisibility/wallVisibility.C"
#include "wallVisibility/pointKind.C"
#include "wallVisibility/inwardCurvature.C"
#include "wallVisibility/cutBlindFaces.C"

// ************************************************************************* //
