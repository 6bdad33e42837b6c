/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadFiles/cadPatchesTest.C"
#include "cadFiles/cadSurfaceTest.C"
#include "cadFiles/cadTriangulationTest.C"
#include "cadFiles/cadUnitTest.C"
#include "cadFiles/gmshOutputTest.C"
#include "cadFiles/stepFaceNamesTest.C"

// ************************************************************************* //
