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
    const boolList& wanted
)
{
    boolList mobile(front_.wallPoints.size(), false);

    forAll(faces, k)
    {
        const face& f = layers_.faces[faces[k]];

        const scalar tolerance =
            UIndirectList<bool>(wanted, f).found(true)
          ? heightTolerance : largeTolerance;

        if (mag(lacking[k]) > tolerance*heightsOf(f[0])[1])
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
    scalarField& mobilities
)
{
    bool any = false;

    forAll(mobilities, c)
    {
        const scalar excess =
            mag(displacements[c])/(maxDisplacement*heightsOf(c)[1]);

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
    const scalarField& reach,
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

        // The less, the longer the column: those are to be smooth
        const scalar h = heightsOf(c)[i];
        const scalar share = shareOf(h, reach[c]);
        const scalar excess = mag(d)/(maxDisplacement*h);

        layers_.points[layers_.index(c, i)] += share/max(excess, scalar(1))*d;
    }
}


Foam::label Foam::movingColumns::lastLevel(const scalarField& reach)
{
    label last = 1;

    forAll(reach, c)
    {
        const scalar* heights = heightsOf(c);

        while
        (
            last < spacing_.nLayers
         && shareOf(heights[last + 1], reach[c]) > leftOutShare
        )
        {
            ++last;
        }
    }

    return last;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::movingColumns::fit
(
    const boolList& wanted,
    const scalar reach,
    const std::function<void(label c)>& moving
)
{
    const vectorField normals(front_.surface.faceNormals());
    const labelList fitted(fittedFaces(front_, spacing_, columns_));
    scalarField m
    (
        mobilities(fitted, lackingHeights(fitted, normals, 1), wanted)
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
    const scalarField reaches(reach*columns_.edges);

    const scalarField lacking(lackingHeights(faces, normals, 1));
    bool lowered = true;

    for (label k = 0; k < maxLowerings && lowered; ++k)
    {
        heights.setMobilities(m);
        lowered = lowerMobilities(heights.displacements(lacking), m);
    }

    forAll(m, c)
    {
        if (m[c] > 0)
        {
            moving(c);
            touch(c);
        }
    }

    // Those above hardly move
    const label nLevels = lastLevel(reaches);

    #pragma omp parallel for schedule(dynamic, 1)
    for (label i = 1; i <= nLevels; ++i)
    {
        displace
        (
            heights.displacements(lackingHeights(faces, normals, i)),
            reaches,
            i
        );
    }
}


// ************************************************************************* //
