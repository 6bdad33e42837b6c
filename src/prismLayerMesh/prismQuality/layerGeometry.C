/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerGeometry.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void layerGeometry::update(const label facei)
{
    visitCells
    (
        layers_, layers_.faces[facei],
        [&](const label i, const UList<faceGeometry>& faces)
        {
            centres_[facei*layers_.nLayers + i - 1] =
                cellGeometry(faces).centre;
            return true;
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

layerGeometry::layerGeometry
(
    const prismLayers& layers,
    const wallAddressing& addressing
)
:
    layers_(layers),
    across_(layers.faces.size()),
    centres_(layers.faces.size()*layers.nLayers)
{
    forAll(across_, facei)
    {
        across_[facei].setSize(layers.faces[facei].size(), -1);
    }
    forAll(addressing.edges, e)
    {
        const labelPair& two = addressing.edgeFaces[e];
        for (const label side : {0, 1})
        {
            if (two[side] >= 0)
            {
                const face& f = layers.faces[two[side]];
                const edge& ends = addressing.edges[e];
                const label k = f.edgeDirection(ends) > 0
                  ? f.find(ends.start()) : f.find(ends.end());
                across_[two[side]][k] = two[1 - side];
            }
        }
    }

    update(identity(layers.faces.size()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void layerGeometry::update(const labelUList& faces)
{
    #pragma omp parallel for schedule(static, 64) if (faces.size() > 64)
    forAll(faces, i)
    {
        update(faces[i]);
    }
}


scalar layerGeometry::lack(const label facei, const faceAims& aims) const
{
    const face& f = layers_.faces[facei];
    const UList<point> own(centres(facei));
    scalar sum = 0;
    const auto add = [&](const auto& points, const point& a, const point* b)
    {
        const faceGeometry here(points);
        sum += sqr(max(aims.planarity - planarity(here, points, a, b), 0.0));
        if (b)
        {
            sum += sqr(cosineLack(here.area, *b - a, aims.cosine))
              + sqr(skewnessExcess(here, points, a, *b, aims.skewness));
        }
    };

    for (label i = 1; i <= layers_.nLayers; ++i)
    {
        add
        (
            levelPoints{layers_, f, i}, own[i - 1],
            i < layers_.nLayers ? &own[i] : nullptr
        );
    }

    forAll(f, k)
    {
        const label g = across(facei, k);
        for (label i = 1; i <= layers_.nLayers; ++i)
        {
            add
            (
                sidePoints{layers_, f[k], f[f.fcIndex(k)], i}, own[i - 1],
                g < 0 ? nullptr : &centres(g)[i - 1]
            );
        }
    }

    return sum;
}

} // End namespace Foam

// ************************************************************************* //
