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

    //- e1 x e2 of the edges at the corner, and (|e1||e2|)^2
    vector normal;
    scalar sqrArea;

    //- From the level below a cell to the level above, and its length squared
    vector side;
    scalar sqrHeight;

    //- Whether the scaled Jacobian is less than a value. If so, the value
    //  becomes the Jacobian.
    bool lower(scalar& value) const
    {
        const scalar product = normal & side;
        const scalar sqrLengths = sqrArea*sqrHeight;

        // Roots only of the few that are less
        if (value > 0 && product > 0 && sqr(product) >= sqr(value)*sqrLengths)
        {
            return false;
        }
        const scalar jacobian = product/max(Foam::sqrt(sqrLengths), VSMALL);
        const bool isLess = jacobian < value;
        value = isLess ? jacobian : value;

        return isLess;
    }
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
    }

    for (label k = 0; k < n; ++k)
    {
        levelCorner& c = corners[k];
        const vector& before = corners[k > 0 ? k - 1 : n - 1].edge;
        c.normal = before ^ c.edge;
        c.sqrArea = magSqr(before)*magSqr(c.edge);
    }
}


//- Sets the sides of the corners of the cell of layer i
template<class Corners>
static void setSides
(
    const prismLayers& layers,
    const face& f,
    const label i,
    Corners& corners
)
{
    const label n = corners.size();
    for (label k = 0; k < n; ++k)
    {
        corners[k].side = layers(f[k], i) - layers(f[k], i - 1);
        corners[k].sqrHeight = magSqr(corners[k].side);
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
    const bool hasArea = facei < layers.nWallFaces();

    scalar worst = GREAT;
    compute(layers, f, layers.nLayers, corners);

    // Mostly the upper cells are the worst
    for (label i = layers.nLayers; i >= lowest && worst >= enough; --i)
    {
        setSides(layers, f, i, corners);
        const auto lookAt = [&]()
        {
            for (const levelCorner& c : corners)
            {
                c.lower(worst);
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


//- jacobianViolation with storage for the corners
template<class Corners>
static scalar jacobianViolation
(
    const prismLayers& layers,
    const face& f,
    const label i,
    const scalar target,
    Corners&& corners
)
{
    scalar sum = 0;
    setSides(layers, f, i, corners);

    for (const label level : {i - 1, i})
    {
        compute(layers, f, level, corners);
        for (const levelCorner& c : corners)
        {
            scalar jacobian = target;
            if (c.lower(jacobian))
            {
                sum += sqr(target - jacobian);
            }
        }
    }

    return Foam::sqrt(sum);
}


//- Calls a function with storage for the corners of a face
template<class Function>
static scalar ofCorners(const face& f, const Function& function)
{
    if (f.size() == 3)
    {
        return function(FixedList<levelCorner, 3>());
    }
    if (f.size() == 4)
    {
        return function(FixedList<levelCorner, 4>());
    }

    return function(List<levelCorner>(f.size()));
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
    return ofCorners(layers.faces[facei], [&](auto&& corners)
    {
        return worstJacobian(layers, facei, enough, lowest, corners);
    });
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
    return ofCorners(f, [&](auto&& corners)
    {
        return jacobianViolation(layers, f, i, target, corners);
    });
}

} // End namespace Foam

// ************************************************************************* //
