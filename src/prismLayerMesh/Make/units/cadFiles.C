/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadFiles/cadPatches.C"
#include "cadFiles/cadSurface.C"
#include "cadFiles/cadTriangulation.C"
#include "cadFiles/cadUnit.C"
#include "cadFiles/gmshOutput.C"
#include "cadFiles/gmshScript.C"
#include "cadFiles/stepFaceNames.C"

// ************************************************************************* //
