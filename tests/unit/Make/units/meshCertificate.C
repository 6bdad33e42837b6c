/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCertificate/cellCornersTest.C"
#include "meshCertificate/layerStacksTest.C"
#include "meshCertificate/meshCellTest.C"
#include "meshCertificate/meshCertificateTest.C"

// ************************************************************************* //
