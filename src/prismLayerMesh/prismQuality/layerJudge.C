/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerJudge.H"
#include "prismQuality.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A column leaves at least this share of its distance from a free side. Room
//  (boundByPlanes) leaves twice as much to columns on the axes of their cones.
static constexpr scalar shareLeft = 0.25;



//- The items of a list for which a test holds, in their order. Many threads
//  make the test at once.
template<class Test>
static labelList selected(const labelUList& items, const Test& test)
{
    boolList holds(items.size(), false);

    #pragma omp parallel for schedule(dynamic, 64) if (items.size() > 128)
    for (label i = 0; i < items.size(); ++i)
    {
        holds[i] = test(items[i]);
    }

    return subset(holds, labelList(items));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

scalar layerJudge::surelyInside(const label facei) const
{
    return layers_.faces[facei].size() == 3
      ? controls_.centreJacobian*attainable_[facei] : GREAT;
}


bool layerJudge::isNearSide(const label facei) const
{
    const face& f = layers_.faces[facei];

    return anyOf(controls_.freeSides, [&](const sidePatch& side)
    {
        return anyOf(f, [&](const label c)
        {
            // Distances in front of the side are negative
            return side.distance(layers_(c, layers_.nLayers))
                 > shareLeft*side.distance(layers_(c, 0));
        });
    });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

layerJudge::layerJudge
(
    const prismLayers& layers,
    const wallSurface& front,
    const wallVisibility& visibility,
    const layerMoveControls& controls,
    const columnTeam& team
)
:
    layers_(layers),
    controls_(controls),
    team_(team),
    attainable_(attainableJacobians(front, visibility)),
    bodies_(findBodies(layers, team))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar layerJudge::penalty
(
    const label facei,
    const label lowest,
    const scalar enough
) const
{
    return jacobianPenalty
    (
        layers_, facei, controls_.goodJacobian*attainable_[facei], enough,
        lowest
    );
}


bool layerJudge::isBelowAttainable(const label facei, const scalar share) const
{
    const scalar smallest = share*attainable_[facei];

    return worstJacobian(layers_, facei, smallest) < smallest;
}


stackFault layerJudge::faultOf
(
    const label facei,
    const stackFault first,
    const stackFault last
) const
{
    const auto isAsked = [&](const stackFault fault)
    {
        return first <= fault && fault <= last;
    };

    // Not the worst one only if below both
    const scalar least = controls_.minJacobian*attainable_[facei];
    const scalar inside = surelyInside(facei);
    const scalar worst = worstJacobian(layers_, facei, min(least, inside));

    if (isAsked(stackFault::belowAttainable) && worst < least)
    {
        return stackFault::belowAttainable;
    }
    if
    (
        isAsked(stackFault::notPositive)
     && (isNearSide(facei) || !isPositiveStack(layers_, facei))
    )
    {
        return stackFault::notPositive;
    }
    if
    (
        isAsked(stackFault::centreOutside)
     && worst < inside
     && !hasPositivePyramids(layers_, facei)
    )
    {
        return stackFault::centreOutside;
    }

    return stackFault::none;
}


List<faultyStack> layerJudge::findFaults
(
    const labelUList& faces,
    const stackFault first,
    const stackFault last
) const
{
    List<stackFault> faults(faces.size());

    #pragma omp parallel for schedule(dynamic, 64) if (faces.size() > 128)
    for (label i = 0; i < faces.size(); ++i)
    {
        faults[i] = faultOf(faces[i], first, last);
    }

    DynamicList<faultyStack> found;
    forAll(faces, i)
    {
        if (faults[i] != stackFault::none)
        {
            found.append({faces[i], faults[i]});
        }
    }

    return List<faultyStack>(std::move(found));
}


labelList layerJudge::findBelowAttainable
(
    const labelUList& faces,
    const scalar share
) const
{
    return selected
    (
        faces,
        [&](const label facei) { return isBelowAttainable(facei, share); }
    );
}


List<overlappingStack> layerJudge::findOverlapping
(
    const labelUList& faces,
    const stackBoxes& groups,
    const scalarField& thickness
) const
{
    return findOverlaps(layers_, faces, bodies_, groups, thickness, team_);
}

} // End namespace Foam

// ************************************************************************* //
