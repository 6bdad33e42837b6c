/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scaledJacobian.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A corner of a front face on some level, and of the cell beside
struct levelCorner
{
    vector edge;
    scalar length;

    //- e1 x e2/(|e1||e2|) of the edges at the corner
    vector normal;

    //- From the level below a cell to the level above, and its length
    vector side;
    scalar height;
};

}


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
        for (label k = 0; k < n; ++k)
        {
            corners[k].side = layers(f[k], i) - layers(f[k], i - 1);
            corners[k].height = max(mag(corners[k].side), VSMALL);
        }

        const auto lookAt = [&]()
        {
            for (const levelCorner& c : corners)
            {
                worst = min(worst, (c.normal & c.side)/c.height);
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


static scalar attainableJacobian
(
    const face& f,
    const pointField& points,
    const wallVisibility& visibility
)
{
    scalar worst = GREAT;

    forAll(f, k)
    {
        const vector next = points[f.nextLabel(k)] - points[f[k]];
        const vector prev = points[f.prevLabel(k)] - points[f[k]];

        worst = min
        (
            worst,
            ((next ^ prev) & visibility.cones[f[k]].axis)
           /max(mag(next)*mag(prev), VSMALL)
        );
    }

    return worst;
}


//- The share of a good Jacobian below which the penalty is larger
static scalar shareOfPenalty(const scalar penalty)
{
    if (penalty < 1)
    {
        return 1 - penalty;
    }

    return penalty < 2 ? (1 - penalty)/(2 - penalty) : -GREAT;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar worstJacobian
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


scalarField attainableJacobians
(
    const wallSurface& front,
    const wallVisibility& visibility
)
{
    scalarField jacobians(front.faces.size());

    forAll(jacobians, facei)
    {
        jacobians[facei] =
            attainableJacobian(front.faces[facei], front.points, visibility);
    }

    return jacobians;
}


scalar jacobianPenalty
(
    const prismLayers& layers,
    const label facei,
    const scalar goodJacobian,
    const scalar enough,
    const label lowest
)
{
    // Faces without area on the wall have only to be positive
    const scalar good = max(goodJacobian, SMALL);
    const scalar smallest = shareOfPenalty(enough)*good;
    const scalar share = worstJacobian(layers, facei, smallest, lowest)/good;

    return share >= 0 ? max(1 - share, scalar(0)) : 1 - share/(1 - share);
}


scalar jacobianViolation
(
    const prismLayers& layers,
    const face& f,
    const label i,
    const scalar target
)
{
    scalar sum = 0;

    for (const label level : {i - 1, i})
    {
        vector before(layers(f[0], level) - layers(f.last(), level));

        forAll(f, k)
        {
            const vector edge
            (
                layers(f.nextLabel(k), level) - layers(f[k], level)
            );
            const vector side(layers(f[k], i) - layers(f[k], i - 1));
            const scalar lengths = mag(before)*mag(edge)*mag(side);
            const scalar jacobian =
                ((before ^ edge) & side)/max(lengths, VSMALL);
            sum += sqr(max(target - jacobian, scalar(0)));
            before = edge;
        }
    }

    return Foam::sqrt(sum);
}

} // End namespace Foam

// ************************************************************************* //
