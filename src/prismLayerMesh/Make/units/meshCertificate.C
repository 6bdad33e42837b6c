/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCertificate/polyhedralMesh.C"
#include "meshCertificate/meshCellShapes.C"
#include "meshCertificate/cellCorners.C"
#include "meshCertificate/meshCell.C"
#include "meshCertificate/meshCellCorners.C"
#include "meshCertificate/meshIntersections.C"
#include "meshCertificate/meshCertificate.C"

// ************************************************************************* //
