/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismQuality.H"
#include "layerOverlaps.H"
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


layerCertificate certify
(
    const prismLayers& layers,
    const columnTeam& team
)
{
    const label nFaces = layers.faces.size();
    boolList outlying(nFaces, false);
    label nCounted = 0, nNotPositive = 0;

    layerCertificate certificate;
    certificate.worstJacobian.setSize(nFaces, GREAT);

    #pragma omp parallel for schedule(dynamic, 64) \
        reduction(+: nCounted, nNotPositive)
    for (label facei = 0; facei < nFaces; ++facei)
    {
        if (!team.counts(layers.faces[facei]))
        {
            continue;
        }
        ++nCounted;
        nNotPositive += !isPositiveStack(layers, facei);
        outlying[facei] = !hasPositivePyramids(layers, facei);
        certificate.worstJacobian[facei] = worstJacobian(layers, facei);
    }

    certificate.nCells = nCounted*layers.nLayers;
    certificate.nStacksNotPositive = nNotPositive;
    certificate.outlyingCentres = findIndices(outlying, true);
    certificate.nOverlaps = findOverlaps
    (
        layers, team.withOwn(identity(nFaces), layers.faces),
        findBodies(layers, team), stackBoxes(layers),
        scalarField(layers.nColumns(), 0), team
    ).size();

    return certificate;
}

} // End namespace Foam

// ************************************************************************* //
