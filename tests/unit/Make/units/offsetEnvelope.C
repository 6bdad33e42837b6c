/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "offsetEnvelope/sparsePointsTest.C"
#include "offsetEnvelope/envelopeRaysTest.C"
#include "offsetEnvelope/offsetEnvelopeTest.C"

// ************************************************************************* //
