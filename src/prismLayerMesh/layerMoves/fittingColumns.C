/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movingColumns.H"
#include "heightFit.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Error of the first height from which columns of a face are displaced
static const scalar heightTolerance = 3e-3;

//- The same where they are not wanted
static const scalar largeTolerance = 1e-2;

//- Excess of the thickness, over what it should be, from which it is fitted
static const scalar thicknessTolerance = 0.04;

//- Height over the length of edges from where on the thickness is fitted
static const scalar lowShare = 0.5;

//- How many rings around them move, too
static const label nRings = 2;

//- Largest displacement of a column, over its height
static const scalar maxDisplacement = 0.4;

//- How often the mobilities of columns that would move further are lowered
static const label maxLowerings = 3;


//- Share of a displacement that is left out
static const scalar leftOutShare = 0.01;


//- Share of a displacement that a column has at a height
static scalar shareOf(const scalar height, const scalar reach)
{
    return 1/(1 + sqr(height/reach));
}


//- Faces whose heights can be fitted: not those between columns, without area,
//  nor with a column that is as long as it may be at its first layer
static labelList fittedFaces
(
    const layerFront& front,
    const layerSpacing& spacing,
    const layerColumns& columns
)
{
    DynamicList<label> fitted(front.nWallFaces);

    for (label facei = 0; facei < front.nWallFaces; ++facei)
    {
        const face& f = front.surface.faces[facei];

        const bool stretched = std::any_of
        (
            f.begin(),
            f.end(),
            [&](const label c)
            {
                return isStretched
                (
                    front.visibility, c,
                    columns.stretch(c, spacing.firstThickness[c])
                );
            }
        );

        if (!stretched)
        {
            fitted.append(facei);
        }
    }

    return labelList(std::move(fitted));
}


//- Those of the faces that have mobile columns
static labelList mobileFaces
(
    const faceList& faces,
    const labelUList& candidates,
    const scalarField& mobilities
)
{
    DynamicList<label> mobile(candidates.size());

    for (const label facei : candidates)
    {
        const face& f = faces[facei];

        if (max(scalarField(mobilities, f)) > 0)
        {
            mobile.append(facei);
        }
    }

    return labelList(std::move(mobile));
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::movingColumns::lackingHeights
(
    const labelUList& faces,
    const vectorField& normals,
    const label i
)
{
    const pointField& wall = front_.surface.points;
    scalarField lacking(faces.size(), 0);

    forAll(faces, k)
    {
        const face& f = layers_.faces[faces[k]];
        const vector& n = normals[faces[k]];

        for (const label c : f)
        {
            lacking[k] +=
            (
                heightsOf(c)[i] - ((layers_(c, i) - wall[c]) & n)
            )/f.size();
        }
    }

    return lacking;
}


Foam::scalarField Foam::movingColumns::mobilities
(
    const labelUList& faces,
    const scalarField& lacking,
    const fitTarget& target
)
{
    boolList mobile(front_.wallPoints.size(), false);

    forAll(faces, k)
    {
        const face& f = layers_.faces[faces[k]];

        if (target.isWrong(f, lacking[k]/heightsOf(f[0])[target.level]))
        {
            UIndirectList<bool>(mobile, f) = true;
        }
    }

    for (label ring = 0; ring < nRings; ++ring)
    {
        for (const label c : findIndices(mobile, true))
        {
            const labelList& neighbours = front_.addressing.pointPoints[c];
            UIndirectList<bool>(mobile, neighbours) = true;
        }
    }

    scalarField result(mobile.size(), 0);
    forAll(result, c)
    {
        result[c] = mobile[c];
    }

    return result;
}


bool Foam::movingColumns::lowerMobilities
(
    const vectorField& displacements,
    const label level,
    scalarField& mobilities
)
{
    bool any = false;

    forAll(mobilities, c)
    {
        const scalar excess =
            mag(displacements[c])/(maxDisplacement*heightsOf(c)[level]);

        if (excess > 1)
        {
            mobilities[c] /= sqr(excess);
            any = true;
        }
    }

    return any;
}


void Foam::movingColumns::displace
(
    const vectorField& displacements,
    const fitTarget& target,
    const label i
)
{
    forAll(displacements, c)
    {
        const vector& d = displacements[c];

        if (magSqr(d) == 0)
        {
            continue;
        }

        const scalar h = heightsOf(c)[i];
        const scalar excess = mag(d)/(maxDisplacement*h);

        layers_.points[layers_.index(c, i)] +=
            target.share(c, h)/max(excess, scalar(1))*d;
    }
}


Foam::labelList Foam::movingColumns::levels
(
    const scalarField& mobilities,
    const fitTarget& target
)
{
    DynamicList<label> moving(spacing_.nLayers);

    for (label i = 1; i <= spacing_.nLayers; ++i)
    {
        bool any = false;

        for (label c = 0; c < mobilities.size() && !any; ++c)
        {
            any = mobilities[c] > 0
             && target.share(c, heightsOf(c)[i]) > leftOutShare;
        }

        if (any)
        {
            moving.append(i);
        }
    }

    return labelList(std::move(moving));
}


void Foam::movingColumns::fit(const fitTarget& target, const mover& moving)
{
    const vectorField normals(front_.surface.faceNormals());
    const labelList fitted(fittedFaces(front_, spacing_, columns_));
    const label level = target.level;
    scalarField m
    (
        mobilities(fitted, lackingHeights(fitted, normals, level), target)
    );

    if (max(m) == 0)
    {
        return;
    }

    heightFit heights
    (
        front_.surface, mobileFaces(layers_.faces, fitted, m)
    );
    const labelList& faces = heights.faces();

    const scalarField lacking(lackingHeights(faces, normals, level));
    bool lowered = true;

    for (label k = 0; k < maxLowerings && lowered; ++k)
    {
        heights.setMobilities(m);
        lowered = lowerMobilities(heights.displacements(lacking), level, m);
    }

    forAll(m, c)
    {
        if (m[c] > 0)
        {
            moving(c);
            touch(c);
        }
    }

    const labelList moved(levels(m, target));

    #pragma omp parallel for schedule(dynamic, 1)
    for (label k = 0; k < moved.size(); ++k)
    {
        const label i = moved[k];

        displace
        (
            heights.displacements(lackingHeights(faces, normals, i)),
            target,
            i
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::movingColumns::fitFirst
(
    const boolList& wanted,
    const scalar reach,
    const mover& moving
)
{
    const auto isWrong = [&](const face& f, const scalar lacking)
    {
        const bool any = UIndirectList<bool>(wanted, f).found(true);

        return mag(lacking) > (any ? heightTolerance : largeTolerance);
    };
    const auto share = [&](const label c, const scalar height)
    {
        return shareOf(height, reach*columns_.edgeLengths[c]);
    };

    fit({1, isWrong, share}, moving);
}


void Foam::movingColumns::fitThickness(const mover& moving)
{
    const auto isWrong = [&](const face&, const scalar lacking)
    {
        return -lacking > thicknessTolerance;
    };
    const auto share = [&](const label c, const scalar height)
    {
        const scalar above = height - spacing_.firstThickness[c];

        return above > 0
          ? 1 - shareOf(above, lowShare*columns_.edgeLengths[c]) : 0;
    };

    fit({spacing_.nLayers, isWrong, share}, moving);
}


// ************************************************************************* //
