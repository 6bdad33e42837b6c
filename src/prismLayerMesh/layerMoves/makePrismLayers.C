/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makePrismLayers.H"
#include "improveLayers.H"
#include "layerGeometry.H"
#include "ranges.H"
#include "UIndirectList.H"

namespace Foam
{

//- What a face has of the thickness and of the first height that are asked for
//  at least, for its columns to be without cause
static const scalar fullShare = 0.95;
static const scalar fullFirstShare = 0.99;

//- Cosine of the half-angle of a cone from which visibility is the cause
static const scalar narrowCosine = 0.5;


//- Whether a face is too low, and none of its columns has a cause
static bool isLowWithoutCause
(
    const layerSpacing& graded,
    const madeLayers& made,
    const label facei
)
{
    const face& f = made.layers.faces[facei];
    const auto hasCause = [&](const label c)
    {
        return made.causes[c] != squeezeCause::none;
    };

    if (anyOf(f, hasCause))
    {
        return false;
    }

    const scalarField first(graded.firstThickness, f);
    const scalarField thickness(graded.thickness, f);
    stackHeights stack(made.layers);
    stack.compute(facei);

    return stack.heights()[0] < fullFirstShare*average(first)
        || sum(stack.heights()) < fullShare*average(thickness);
}


//- Columns of faces that are too low, where none has a cause
static labelList lowColumns
(
    const layerFront& front,
    const layerSpacing& graded,
    const madeLayers& made
)
{
    boolList isLow(front.nWallFaces);

    #pragma omp parallel for schedule(static, 256)
    forAll(isLow, facei)
    {
        isLow[facei] = isLowWithoutCause(graded, made, facei);
    }

    DynamicList<label> low;
    forAll(isLow, facei)
    {
        if (isLow[facei])
        {
            low.append(made.layers.faces[facei]);
        }
    }

    return labelList(std::move(low));
}


//- Why a column of full room is on a low face
static squeezeCause causeOfLow
(
    const layerFront& front,
    const layerSpacing& graded,
    const layerColumns& columns,
    const label c
)
{
    const scalar stretch = columns.stretch(c, graded.thickness[c]);

    return isStretched(front.visibility, c, stretch) ? squeezeCause::stretch
      : squeezeCause::validity;
}


//- What it is that does not let the cells be positive
static squeezeCause causeOfInvalid
(
    const layerFront& front,
    const List<pointKind>& kinds,
    const label c
)
{
    bool hollow = isOnConcaveEdge(kinds[front.wallPoints[c]]);

    for (const label q : front.addressing.pointPoints[c])
    {
        hollow = hollow || isOnConcaveEdge(kinds[front.wallPoints[q]]);
    }

    return hollow ? squeezeCause::concaveCorner
      : front.visibility.cones[c].cosine < narrowCosine
      ? squeezeCause::visibility
      : squeezeCause::validity;
}


static bool isLower
(
    const layerSpacing& asked,
    const layerSpacing& graded,
    const label c
)
{
    return graded.thickness[c] < asked.thickness[c]
        || graded.firstThickness[c] < asked.firstThickness[c];
}


void nameCauses
(
    const layerFront& front,
    const List<pointKind>& kinds,
    const layerSpacing& asked,
    const layerSpacing& graded,
    const layerColumns& columns,
    madeLayers& made
)
{
    List<squeezeCause>& causes = made.causes;

    boolList gaveWay(causes.size(), false);
    UIndirectList<bool>(gaveWay, made.gaveWay) = true;

    for (const label c : lowColumns(front, graded, made))
    {
        causes[c] = gaveWay[c]
          ? squeezeCause::quality : causeOfLow(front, graded, columns, c);
    }

    forAll(causes, c)
    {
        if (causes[c] == squeezeCause::validity)
        {
            causes[c] = causeOfInvalid(front, kinds, c);
        }
        else if (causes[c] == squeezeCause::none && isLower(asked, graded, c))
        {
            causes[c] = columns.onLevelSets
              ? squeezeCause::levelSet : squeezeCause::transition;
        }
    }
}


// * * * * * * * * * * * * * *  Make Prism Layers  * * * * * * * * * * * * * //

madeLayers makePrismLayers
(
    const layerFront& front,
    const layerSpacing& spacing,
    const layerColumns& columns,
    const layerMoveControls& controls,
    const columnTeam& team
)
{
    layerEditor editor
    (
        front, spacing, columns, controls, front.constraints, team
    );
    const layerJudge judge
    (
        editor.layers(), front.surface, front.visibility, controls, team
    );

    madeLayers made;
    made.certified = certifyLayers(editor, judge);
    if (made.certified.pointsWithoutHeight.size())
    {
        return made;
    }
    made.gaveWay = improveLayers(editor, judge, made.certified.tolerated);
    made.thickness = editor.thickness();
    made.causes = editor.causes();
    made.layers = editor.release();

    for (const label c : made.gaveWay)
    {
        const vector column
        (
            made.layers(c, spacing.nLayers) - made.layers(c, 0)
        );
        const scalar height = front.visibility.heightCosine(c, column);

        if (height < made.thickness[c])
        {
            made.thickness[c] = height;
            made.causes[c] = made.causes[c] == squeezeCause::none
              ? squeezeCause::quality : made.causes[c];
        }
    }

    team.columns.update(made.thickness);
    team.columns.update(made.causes);

    return made;
}

} // End namespace Foam

// ************************************************************************* //
