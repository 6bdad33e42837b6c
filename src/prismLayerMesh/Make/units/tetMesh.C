/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetMesh/tetrahedralize.C"
#include "tetMesh/tetEditor.C"
#include "tetMesh/tetInserter.C"
#include "tetMesh/refineTets.C"
#include "tetMesh/planeTriangulation.C"

// ************************************************************************* //
