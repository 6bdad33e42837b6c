/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sets/markedGridTest.C"
#include "sets/boxGridTest.C"
#include "sets/disjointSetsTest.C"
#include "sets/reachGridTest.C"
#include "sets/invertCompactTest.C"

// ************************************************************************* //
