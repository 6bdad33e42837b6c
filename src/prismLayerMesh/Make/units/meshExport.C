/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshExport/innerPoint.C"
#include "meshExport/elementShape.C"
#include "meshExport/cellDivision.C"
#include "meshExport/planeElements.C"
#include "meshExport/elementMesh.C"
#include "meshExport/writeElements.C"
#include "meshExport/writeVtu.C"

// ************************************************************************* //
