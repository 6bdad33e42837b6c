/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetMesh/tetrahedralizeTest.C"
#include "tetMesh/planeTriangulationTest.C"
#include "tetMesh/tetEditorTest.C"
#include "tetMesh/changeRoundsTest.C"
#include "tetMesh/refineTetsTest.C"

// ************************************************************************* //
