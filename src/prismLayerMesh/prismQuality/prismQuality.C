/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "layerCell.H"
#include "prismQuality.H"
#include "stackHeights.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- e1 x e2/(|e1||e2|) of the edges at corner k of a front face on level i
static vector cornerNormal
(
    const prismLayers& layers,
    const face& f,
    const label k,
    const label i
)
{
    const point& p = layers(f[k], i);
    const vector before(p - layers(f.prevLabel(k), i));
    const vector after(layers(f.nextLabel(k), i) - p);

    return (before ^ after)
       /max(::sqrt(magSqr(before)*magSqr(after)), VSMALL);
}


//- Lowest layer of the stack whose cell is not positive, or 0
static label lowestInvalidLayer(const prismLayers& layers, const label facei)
{
    for (label i = 1; i <= layers.nLayers; ++i)
    {
        if (!isPositive(layers, facei, i))
        {
            return i;
        }
    }

    return 0;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::worstJacobian
(
    const prismLayers& layers,
    const label facei,
    const scalar enough
)
{
    const face& f = layers.faces[facei];
    const bool hasArea = facei < layers.nWallFaces();

    scalar worst = GREAT;
    List<vector> normals(f.size());

    forAll(f, k)
    {
        normals[k] = cornerNormal(layers, f, k, layers.nLayers);
    }

    // Mostly the upper cells are the worst
    for (label i = layers.nLayers; i > 0 && worst >= enough; --i)
    {
        forAll(f, k)
        {
            const vector side(layers(f[k], i) - layers(f[k], i - 1));
            scalar jacobian = normals[k] & side;

            if (i > 1 || hasArea)
            {
                normals[k] = cornerNormal(layers, f, k, i - 1);
                jacobian = min(jacobian, normals[k] & side);
            }

            worst = min(worst, jacobian/max(mag(side), VSMALL));
        }
    }

    return worst;
}


Foam::List<Foam::labelPair> Foam::findInvalidStacks(const prismLayers& layers)
{
    return findInvalidStacks(layers, identity(layers.faces.size()));
}


Foam::List<Foam::labelPair> Foam::findInvalidStacks
(
    const prismLayers& layers,
    const labelUList& candidates
)
{
    DynamicList<labelPair> invalid;

    for (const label facei : candidates)
    {
        const label i = lowestInvalidLayer(layers, facei);

        if (i)
        {
            invalid.append(labelPair(facei, i));
        }
    }

    sort(invalid);

    return List<labelPair>(std::move(invalid));
}


Foam::layerCertificate Foam::certify(const prismLayers& layers)
{
    layerCertificate certificate;
    certificate.nCells = layers.faces.size()*layers.nLayers;
    certificate.worstJacobian.setSize(layers.faces.size());

    stackHeights stack(layers);

    forAll(layers.faces, facei)
    {
        stack.compute(facei);

        for (label i = 1; i <= layers.nLayers; ++i)
        {
            certificate.nInvalidCells +=
                !isPositive(layers, facei, i) || stack.heights()[i - 1] <= 0;
        }

        certificate.worstJacobian[facei] = worstJacobian(layers, facei);
    }

    certificate.nIntersectingPairs = findIntersections(layers).size();

    return certificate;
}


// ************************************************************************* //
