/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fitHeights.H"
#include "ListOps.H"
#include "ranges.H"
#include "stageProgress.H"

namespace Foam
{

//- Returns how many times further a displacement [m] goes than it may at a
//  height [m]
static scalar excessOf
(
    const layerMoveControls& controls,
    const vector& displacement,
    const scalar height
)
{
    return mag(displacement)/(controls.maxDisplacement*height);
}


//- Displace own columns at a level by their shares
static void displace
(
    const vectorField& displacements,
    const fittedWall& fitted,
    const displacementShare& share,
    const label level,
    layerEditor& editor
)
{
    forAll(displacements, p)
    {
        const vector& d = displacements[p];
        const label c = fitted.ownColumns[p];

        if (c >= 0 && magSqr(d) > 0)
        {
            const scalar height = editor.heights(c)[level];
            const scalar ofLevel = share(c, height)
               /max(excessOf(editor.controls(), d, height), scalar(1));

            editor.setPoint(c, level, editor.layers()(c, level) + ofLevel*d);
        }
    }
}


//- The own columns that are mobile
static labelList mobileColumns(const fittedWall& fitted)
{
    DynamicList<label> columns;
    forAll(fitted.ownColumns, p)
    {
        if (fitted.ownColumns[p] >= 0 && fitted.mobilities[p] > 0)
        {
            columns.append(fitted.ownColumns[p]);
        }
    }

    return labelList(std::move(columns));
}


//- The levels at which mobile columns have a share
static labelList levelsOf
(
    const layerEditor& editor,
    const labelUList& mobile,
    const displacementShare& share
)
{
    DynamicList<label> levels;
    for (label i = 1; i <= editor.spacing().nLayers; ++i)
    {
        const bool any = anyOf(mobile, [&](const label c)
        {
            return share(c, editor.heights(c)[i])
                 > editor.controls().leftOutShare;
        });
        if (any)
        {
            levels.append(i);
        }
    }

    labelList all(editor.team().gather(levels));
    inplaceUniqueSort(all);

    return all;
}


//- Displaces the mobile own columns of a fit. The fit of a level asks for a
//  displacement, of which a column makes its share at this level, at most as
//  much as it may. Publishes the changes. Collective.
//  heights: the fit, with its mobilities
//  missing: returns the heights [m] that the faces are too low by up to a level
static void displaceColumns
(
    const fittedWall& fitted,
    const heightFit& heights,
    const displacementShare& share,
    const std::function<scalarField(label level)>& missing,
    layerEditor& editor
)
{
    const labelList columns(mobileColumns(fitted));
    const labelList levels(levelsOf(editor, columns, share));
    List<scalarField> missingAt(levels.size());
    forAll(levels, k)
    {
        missingAt[k] = missing(levels[k]);
    }

    for (const label c : columns)
    {
        editor.remember(c);
        editor.touch(c);
    }

    #pragma omp parallel for schedule(dynamic, 1)
    forAll(levels, k)
    {
        displace
        (
            heights.displacements(missingAt[k]), fitted, share, levels[k],
            editor
        );
        missingAt[k].clear();
    }
    editor.publish(columns);
}


// * * * * * * * * * * * * * * *  Fit Heights  * * * * * * * * * * * * * * * //

namespace
{

//- What a fit of columns to their heights is for
struct fitTarget
{
    //- Level whose heights are looked at
    label level;

    //- Whether a face is to be fitted if a share of its height is missing there
    std::function<bool(const face& f, scalar missing)> isWrong;

    displacementShare share;
};

}


//- Share of a displacement that a column has at a height
static scalar shareAt(const scalar height, const scalar reach)
{
    return 1/(1 + sqr(height/reach));
}


//- Returns whether each column is as long as it may be at its first layer
static boolList stretchedAtFirst(const layerEditor& editor)
{
    boolList isLong(editor.front().wallPoints.size());

    #pragma omp parallel for schedule(static, 256)
    forAll(isLong, c)
    {
        const scalar height = editor.spacing().firstThickness[c];
        isLong[c] = isStretched
        (
            editor.front().visibility, c, editor.proposed().stretch(c, height)
        );
    }

    return isLong;
}


//- Faces whose heights can be fitted: not those between columns, without area,
//  nor with a column that is as long as it may be
static labelList fittedFaces(const layerEditor& editor)
{
    const layerFront& front = editor.front();
    const boolList isLong(stretchedAtFirst(editor));
    boolList isFitted(front.nWallFaces);

    #pragma omp parallel for schedule(static, 256)
    forAll(isFitted, facei)
    {
        const face& f = front.surface.faces[facei];
        isFitted[facei] = !anyOf(f, [&](const label c) { return isLong[c]; });
    }

    return findIndices(isFitted, true);
}


//- Returns the heights [m] that faces are too low by, up to a level.
//  normals: normals of all faces
static scalarField missingHeights
(
    const layerEditor& editor,
    const labelUList& faces,
    const vectorField& normals,
    const label level
)
{
    const pointField& wall = editor.front().surface.points;
    const prismLayers& layers = editor.layers();
    scalarField missing(faces.size(), 0);

    #pragma omp parallel for schedule(static, 256)
    forAll(faces, k)
    {
        const face& f = layers.faces[faces[k]];
        const vector& n = normals[faces[k]];

        for (const label c : f)
        {
            missing[k] +=
            (
                editor.heights(c)[level] - ((layers(c, level) - wall[c]) & n)
            )/f.size();
        }
    }

    return missing;
}


//- 1 of columns near faces that are wrong, 0 of others
static scalarField firstMobilities
(
    const layerEditor& editor,
    const labelUList& faces,
    const scalarField& missing,
    const fitTarget& target
)
{
    const layerFront& front = editor.front();
    boolList isWrong(faces.size());

    #pragma omp parallel for schedule(static, 256)
    forAll(faces, k)
    {
        const face& f = front.surface.faces[faces[k]];
        isWrong[k] = target.isWrong
        (
            f, missing[k]/editor.heights(f[0])[target.level]
        );
    }

    boolList mobile(front.wallPoints.size(), false);
    for (const label k : findIndices(isWrong, true))
    {
        UIndirectList<bool>(mobile, front.surface.faces[faces[k]]) = true;
    }

    editor.team().columns.update(mobile);
    for (label ring = 0; ring < editor.controls().nRings; ++ring)
    {
        for (const label c : findIndices(mobile, true))
        {
            UIndirectList<bool>(mobile, front.addressing.pointPoints[c]) = true;
        }
        editor.team().columns.update(mobile);
    }

    scalarField mobilities(mobile.size(), 0);
    forAll(mobilities, c)
    {
        mobilities[c] = mobile[c] && !editor.isFixed(c);
    }

    return mobilities;
}


//- Lower the mobilities of columns that go too far at the level of the fit, a
//  few times, and give the fit what they are
static void fitMobilities
(
    const layerMoveControls& controls,
    const scalarField& missing,
    fittedWall& fitted,
    heightFit& heights
)
{
    const auto lower = [&]()
    {
        heights.setMobilities(fitted.mobilities);
        const vectorField displacements(heights.displacements(missing));
        bool lowered = false;

        forAll(displacements, p)
        {
            const scalar excess =
                excessOf(controls, displacements[p], fitted.heights[p]);

            if (excess > 1)
            {
                fitted.mobilities[p] /= sqr(excess);
                lowered = true;
            }
        }

        return lowered;
    };
    repeatUntilStable("lowering mobilities", controls.maxLowerings, lower);
}


//- Displace columns so that the cells on a face have the heights that its
//  columns have in the mean
static void fit(layerEditor& editor, const fitTarget& target)
{
    const layerFront& front = editor.front();
    const vectorField normals(front.surface.faceNormals());
    const labelList candidates(fittedFaces(editor));
    const scalarField mobilities
    (
        firstMobilities
        (
            editor, candidates,
            missingHeights(editor, candidates, normals, target.level), target
        )
    );

    if (!editor.team().any(max(mobilities) > 0))
    {
        return;
    }

    fittedWall fitted
    (
        makeFittedWall(editor, candidates, mobilities, target.level)
    );
    const auto missing = [&](const label level)
    {
        return fitted.ofAll
        (
            editor.team(),
            missingHeights(editor, fitted.counted, normals, level)
        );
    };
    heightFit heights
    (
        fitted.wall, identity(fitted.wall.faces.size()),
        editor.controls().damping
    );
    fitMobilities(editor.controls(), missing(target.level), fitted, heights);
    displaceColumns(fitted, heights, target.share, missing, editor);
}


void fitFirstHeights
(
    layerEditor& editor,
    const boolList& wanted,
    const scalar reach
)
{
    const layerMoveControls& controls = editor.controls();
    const auto isWrong = [&](const face& f, const scalar missing)
    {
        const bool any = UIndirectList<bool>(wanted, f).found(true);

        return mag(missing)
          > (any ? controls.heightTolerance : controls.largeTolerance);
    };
    const auto share = [&](const label c, const scalar height)
    {
        return shareAt(height, reach*editor.proposed().edgeLengths[c]);
    };

    fit(editor, {1, isWrong, share});
}


void fitThickness(layerEditor& editor)
{
    const layerMoveControls& controls = editor.controls();
    const auto isWrong = [&](const face&, const scalar missing)
    {
        return -missing > controls.thicknessTolerance;
    };
    const auto share = [&](const label c, const scalar height)
    {
        const scalar above = height - editor.spacing().firstThickness[c];
        const scalar reach =
            controls.thicknessReach*editor.proposed().edgeLengths[c];

        return above > 0 ? 1 - shareAt(above, reach) : 0;
    };

    fit(editor, {editor.spacing().nLayers, isWrong, share});
}

} // End namespace Foam

// ************************************************************************* //
