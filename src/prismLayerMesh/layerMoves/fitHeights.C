/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fitHeights.H"
#include "heightFit.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- What a fit of columns to their heights is for
struct fitTarget
{
    //- Level whose heights are looked at
    label level;

    //- Whether a face is to be fitted if a share of its height is missing there
    std::function<bool(const face& f, scalar missing)> isWrong;

    //- Share of a displacement that a column has at a height [m]
    std::function<scalar(label c, scalar height)> share;
};

}


//- Share of a displacement that a column has at a height
static scalar shareAt(const scalar height, const scalar reach)
{
    return 1/(1 + sqr(height/reach));
}


//- Whether a column is as long as it may be at its first layer
static bool isStretchedAtFirst(const layerEditor& editor, const label c)
{
    return isStretched
    (
        editor.front().visibility, c,
        editor.proposed().stretch(c, editor.spacing().firstThickness[c])
    );
}


//- Faces whose heights can be fitted: not those between columns, without area,
//  nor with a column that is as long as it may be
static labelList fittedFaces(const layerEditor& editor)
{
    const layerFront& front = editor.front();

    return subsetList(identity(front.nWallFaces), [&](const label facei)
    {
        const face& f = front.surface.faces[facei];

        return std::none_of(f.begin(), f.end(), [&](const label c)
        {
            return isStretchedAtFirst(editor, c);
        });
    });
}


//- The faces that have mobile columns
static labelList mobileFaces
(
    const faceList& faces,
    const labelUList& candidates,
    const scalarField& mobilities
)
{
    return subsetList(candidates, [&](const label facei)
    {
        return max(scalarField(mobilities, faces[facei])) > 0;
    });
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
    boolList mobile(front.wallPoints.size(), false);

    forAll(faces, k)
    {
        const face& f = front.surface.faces[faces[k]];

        if (target.isWrong(f, missing[k]/editor.heights(f[0])[target.level]))
        {
            UIndirectList<bool>(mobile, f) = true;
        }
    }

    for (label ring = 0; ring < editor.controls().nRings; ++ring)
    {
        for (const label c : findIndices(mobile, true))
        {
            UIndirectList<bool>
            (
                mobile, front.addressing.pointPoints[c]
            ) = true;
        }
    }

    scalarField mobilities(mobile.size(), 0);
    forAll(mobilities, c)
    {
        mobilities[c] = mobile[c] && !editor.isFixed(c);
    }

    return mobilities;
}


//- How many times further a displacement goes than it may
static scalar excessOf
(
    const layerEditor& editor,
    const label c,
    const vector& displacement,
    const label level
)
{
    return mag(displacement)
       /(editor.controls().maxDisplacement*editor.heights(c)[level]);
}


//- Lower the mobilities of columns that go too far at a level, a few times, and
//  give the fit what they are
static void fitMobilities
(
    const layerEditor& editor,
    const scalarField& missing,
    const label level,
    heightFit& heights,
    scalarField& mobilities
)
{
    bool lowered = true;

    for (label k = 0; k < editor.controls().maxLowerings && lowered; ++k)
    {
        heights.setMobilities(mobilities);
        const vectorField displacements(heights.displacements(missing));
        lowered = false;

        forAll(mobilities, c)
        {
            const scalar excess = excessOf(editor, c, displacements[c], level);

            if (excess > 1)
            {
                mobilities[c] /= sqr(excess);
                lowered = true;
            }
        }
    }
}


//- Displace columns at a level by their shares
static void displace
(
    const vectorField& displacements,
    const fitTarget& target,
    const label level,
    layerEditor& editor
)
{
    forAll(displacements, c)
    {
        const vector& d = displacements[c];

        if (magSqr(d) > 0)
        {
            const scalar share = target.share(c, editor.heights(c)[level])
               /max(excessOf(editor, c, d, level), scalar(1));

            editor.setPoint(c, level, editor.layers()(c, level) + share*d);
        }
    }
}


//- The levels at which mobile columns have a share
static labelList levelsOf
(
    const layerEditor& editor,
    const scalarField& mobilities,
    const fitTarget& target
)
{
    DynamicList<label> levels;

    for (label i = 1; i <= editor.spacing().nLayers; ++i)
    {
        bool any = false;

        for (label c = 0; c < mobilities.size() && !any; ++c)
        {
            any = mobilities[c] > 0
             && target.share(c, editor.heights(c)[i])
              > editor.controls().leftOutShare;
        }

        if (any)
        {
            levels.append(i);
        }
    }

    return labelList(std::move(levels));
}


//- Displace columns so that the cells on a face have the heights that its
//  columns have in the mean
static void fit(layerEditor& editor, const fitTarget& target)
{
    const layerFront& front = editor.front();
    const vectorField normals(front.surface.faceNormals());
    const auto missing = [&](const labelUList& faces, const label level)
    {
        return missingHeights(editor, faces, normals, level);
    };

    const labelList fitted(fittedFaces(editor));
    scalarField mobilities
    (
        firstMobilities(editor, fitted, missing(fitted, target.level), target)
    );

    if (max(mobilities) == 0)
    {
        return;
    }

    heightFit heights
    (
        front.surface,
        mobileFaces(front.surface.faces, fitted, mobilities),
        editor.controls().damping
    );
    const labelList& faces = heights.faces();
    fitMobilities
    (
        editor, missing(faces, target.level), target.level, heights, mobilities
    );

    forAll(mobilities, c)
    {
        if (mobilities[c] > 0)
        {
            editor.remember(c);
            editor.touch(c);
        }
    }

    const labelList levels(levelsOf(editor, mobilities, target));

    #pragma omp parallel for schedule(dynamic, 1)
    forAll(levels, k)
    {
        displace
        (
            heights.displacements(missing(faces, levels[k])),
            target, levels[k], editor
        );
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
