/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "innerWeights.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The weights of the circumcentre of a triangle, or zeros if it has no area
static FixedList<scalar, 3> circumWeights(const FixedList<point, 3>& p)
{
    const scalar aa = magSqr(p[2] - p[1]);
    const scalar bb = magSqr(p[0] - p[2]);
    const scalar cc = magSqr(p[1] - p[0]);
    FixedList<scalar, 3> w
    ({
        aa*(bb + cc - aa), bb*(cc + aa - bb), cc*(aa + bb - cc)
    });
    const scalar total = w[0] + w[1] + w[2];
    for (scalar& x : w)
    {
        x = total > VSMALL ? x/total : 0;
    }

    return w;
}


//- The weights of the circumcentre of a tetrahedron, or zeros if it has no
//  volume
static FixedList<scalar, 4> circumWeights(const FixedList<point, 4>& p)
{
    const vector u(p[1] - p[0]), v(p[2] - p[0]), w(p[3] - p[0]);
    const scalar det = u & (v ^ w);
    if (mag(det) < VSMALL)
    {
        return FixedList<scalar, 4>(Zero);
    }
    const vector x
    (
        (magSqr(u)*(v ^ w) + magSqr(v)*(w ^ u) + magSqr(w)*(u ^ v))/(2*det)
    );
    const scalar a = (x & (v ^ w))/det;
    const scalar b = (x & (w ^ u))/det;
    const scalar c = (x & (u ^ v))/det;

    return FixedList<scalar, 4>({1 - a - b - c, a, b, c});
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

template<unsigned n>
FixedList<scalar, n> innerWeights
(
    const FixedList<point, n>& corners,
    const scalar leastShare
)
{
    FixedList<scalar, n> weights(circumWeights(corners));
    scalar way = 1;
    bool isCentral = true;
    for (const scalar x : weights)
    {
        isCentral = isCentral && x == 0;
        if (n*x < leastShare)
        {
            way = min(way, (1 - leastShare)/(1 - n*x));
        }
    }
    for (scalar& x : weights)
    {
        x = 1.0/n + (isCentral ? 0 : way*(x - 1.0/n));
    }

    return weights;
}


template FixedList<scalar, 3> innerWeights(const FixedList<point, 3>&, scalar);
template FixedList<scalar, 4> innerWeights(const FixedList<point, 4>&, scalar);


face rootsOf(const prismLayers& layers, const label facei)
{
    face f(layers.faces[facei]);
    for (label& c : f)
    {
        c = layers.root(c);
    }

    return f;
}


scalarList innerWeights
(
    const prismLayers& layers,
    const label facei,
    const scalar leastShare
)
{
    const face& f = layers.faces[facei];
    scalarList weights(f.size(), 1.0/f.size());
    if (f.size() != 3)
    {
        return weights;
    }
    if (facei < layers.nWallFaces())
    {
        FixedList<point, 3> corners;
        forAll(corners, k)
        {
            corners[k] =
                0.5*(layers(f[k], 0) + layers(f[k], layers.nLayers));
        }
        const FixedList<scalar, 3> inner(innerWeights(corners, leastShare));
        std::copy(inner.begin(), inner.end(), weights.begin());

        return weights;
    }
    forAll(f, k)
    {
        const label root = layers.root(f[k]);
        const bool isAlone =
            root != layers.root(f[f.fcIndex(k)])
         && root != layers.root(f[f.rcIndex(k)]);
        if (isAlone)
        {
            weights = 0.25;
            weights[k] = 0.5;
        }
    }

    return weights;
}

} // End namespace Foam

// ************************************************************************* //
