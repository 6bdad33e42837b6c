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

//- A corner of a front face on some level
struct levelCorner
{
    vector edge;
    scalar length;

    //- e1 x e2/(|e1||e2|) of the edges at the corner
    vector normal;
};


template<class Corners>
static void compute
(
    const prismLayers& layers,
    const face& f,
    const label level,
    Corners& corners
)
{
    const label n = corners.size();

    for (label k = 0; k < n; ++k)
    {
        corners[k].edge =
            layers(f[k + 1 < n ? k + 1 : 0], level) - layers(f[k], level);
        corners[k].length = mag(corners[k].edge);
    }

    for (label k = 0; k < n; ++k)
    {
        const levelCorner& before = corners[k > 0 ? k - 1 : n - 1];

        corners[k].normal = (before.edge ^ corners[k].edge)
           /max(before.length*corners[k].length, VSMALL);
    }
}


//- worstJacobian with storage for the corners
template<class Corners>
static scalar worstJacobian
(
    const prismLayers& layers,
    const label facei,
    const scalar enough,
    const label lowest,
    Corners&& corners
)
{
    const face& f = layers.faces[facei];
    const label n = corners.size();
    const bool hasArea = facei < layers.nWallFaces();

    scalar worst = GREAT;
    compute(layers, f, layers.nLayers, corners);

    // Mostly the upper cells are the worst
    for (label i = layers.nLayers; i >= lowest && worst >= enough; --i)
    {
        const auto lookAt = [&]()
        {
            for (label k = 0; k < n; ++k)
            {
                const vector side(layers(f[k], i) - layers(f[k], i - 1));

                worst = min
                (
                    worst, (corners[k].normal & side)/max(mag(side), VSMALL)
                );
            }
        };

        lookAt();

        if (worst >= enough && (i > 1 || hasArea))
        {
            compute(layers, f, i - 1, corners);
            lookAt();
        }
    }

    return worst;
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
    const scalar enough,
    const label lowest
)
{
    const label n = layers.faces[facei].size();

    if (n == 3)
    {
        return worstJacobian
        (
            layers, facei, enough, lowest, FixedList<levelCorner, 3>()
        );
    }
    if (n == 4)
    {
        return worstJacobian
        (
            layers, facei, enough, lowest, FixedList<levelCorner, 4>()
        );
    }

    return worstJacobian(layers, facei, enough, lowest, List<levelCorner>(n));
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
    const label nFaces = layers.faces.size();
    boolList outlying(nFaces, false);
    label nInvalid = 0;

    layerCertificate certificate;
    certificate.nCells = nFaces*layers.nLayers;
    certificate.worstJacobian.setSize(nFaces);

    #pragma omp parallel
    {
        stackHeights stack(layers);

        #pragma omp for schedule(dynamic, 64) reduction(+: nInvalid)
        for (label facei = 0; facei < nFaces; ++facei)
        {
            stack.compute(facei);

            for (label i = 1; i <= layers.nLayers; ++i)
            {
                nInvalid += !isPositive(layers, facei, i)
                    || stack.heights()[i - 1] <= 0;
            }

            certificate.worstJacobian[facei] = worstJacobian(layers, facei);
            outlying[facei] = !hasPositivePyramids(layers, facei);
        }
    }

    certificate.nInvalidCells = nInvalid;
    certificate.outlyingCentres = findIndices(outlying, true);
    certificate.nIntersectingPairs =
        findOverlaps(layers, boolList(layers.faces.size(), true)).size();

    return certificate;
}


// ************************************************************************* //
