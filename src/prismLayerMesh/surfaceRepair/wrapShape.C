/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wrapShape.H"
#include "bitSet.H"
#include "unitConversion.H"
#include "wallVisibility.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Least angle [deg] between the axis of a point's visibility cone and a face:
//  layers can begin there
static constexpr scalar smallestAngle = 10;

//- Least height of a triangle over its longest edge
static constexpr scalar leastHeight = 0.1;

//- The share of angles and heights in the wrap that is enough, where it has
//  smaller ones
static constexpr scalar keptShare = 0.5;


//- Returns the height of each triangle over its longest edge
static scalarField heightsOf(const wallSurface& wrap)
{
    scalarField heights(wrap.faces.size());

    forAll(heights, facei)
    {
        const face& f = wrap.faces[facei];
        const scalar longest =
            f.faceEdge(f.longestEdge(wrap.points)).mag(wrap.points);
        heights[facei] = 2*f.mag(wrap.points)/max(sqr(longest), VSMALL);
    }

    return heights;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

scalarField wrapShape::sines(const wallSurface& wrap) const
{
    const wallVisibility visibility(makeWallVisibility(wrap, addressing_));
    scalarField sines(visibility.cones.size());

    forAll(sines, p)
    {
        sines[p] = visibility.cones[p].cosine;
    }

    return sines;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

wrapShape::wrapShape(const wallSurface& wrap, const wallAddressing& addressing)
:
    addressing_(addressing),
    leastHeights_(min(keptShare*heightsOf(wrap), leastHeight)),
    leastSines_(sines(wrap))
{
    // Faces around points with very narrow cones stay as they are
    const scalar least = Foam::sin(degToRad(smallestAngle));
    for (scalar& sine : leastSines_)
    {
        sine = min(max(keptShare*sine, sqr(keptShare)*least), least);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList wrapShape::facesAtFault(const wallSurface& wrap) const
{
    bitSet fault(wrap.faces.size());

    const scalarField now(heightsOf(wrap));
    forAll(now, facei)
    {
        if (now[facei] < leastHeights_[facei])
        {
            fault.set(facei);
        }
    }

    const scalarField sinesNow(sines(wrap));
    forAll(sinesNow, p)
    {
        if (sinesNow[p] < leastSines_[p])
        {
            fault.set(addressing_.pointFaces[p]);
        }
    }

    return fault.sortedToc();
}

} // End namespace Foam

// ************************************************************************* //
