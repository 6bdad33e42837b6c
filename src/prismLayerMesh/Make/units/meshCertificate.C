/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCertificate/polyhedralMesh.C"
#include "meshCertificate/meshCell.C"
#include "meshCertificate/meshCertificate.C"

// ************************************************************************* //
