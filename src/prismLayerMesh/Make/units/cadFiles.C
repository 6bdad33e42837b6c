/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadFiles/cadTriangulation.C"
#include "cadFiles/cadSurface.C"
#include "cadFiles/stepFaceNames.C"
#include "cadFiles/gmshOutput.C"

// ************************************************************************* //
