/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismQuality.H"
#include "nestedBodies.H"
#include "scaledJacobian.H"
#include "stackHeights.H"

namespace Foam
{

bool isPositiveStack(const prismLayers& layers, const label facei)
{
    stackHeights stack(layers);
    stack.compute(facei);

    if (min(stack.heights()) <= 0)
    {
        return false;
    }

    for (label i = layers.nLayers; i > 0; --i)
    {
        if (!isPositive(layers, facei, i))
        {
            return false;
        }
    }

    return true;
}


layerCertificate certify(const prismLayers& layers)
{
    const label nFaces = layers.faces.size();
    boolList outlying(nFaces, false);
    label nNotPositive = 0;

    layerCertificate certificate;
    certificate.nCells = nFaces*layers.nLayers;
    certificate.worstJacobian.setSize(nFaces);

    #pragma omp parallel for schedule(dynamic, 64) reduction(+: nNotPositive)
    for (label facei = 0; facei < nFaces; ++facei)
    {
        nNotPositive += !isPositiveStack(layers, facei);
        outlying[facei] = !hasPositivePyramids(layers, facei);
        certificate.worstJacobian[facei] = worstJacobian(layers, facei);
    }

    certificate.nStacksNotPositive = nNotPositive;
    certificate.outlyingCentres = findIndices(outlying, true);
    certificate.nIntersectingPairs =
        findOverlaps(layers, identity(nFaces), findBodies(layers)).size();

    return certificate;
}

} // End namespace Foam

// ************************************************************************* //
