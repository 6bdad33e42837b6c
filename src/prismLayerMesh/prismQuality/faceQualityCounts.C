/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceQualityCounts.H"
#include "tetPointRef.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Static Member Data  * * * * * * * * * * * * //

const char* const faceQualityCounts::names[nBounds] =
{
    "maxNonOrtho", "maxInternalSkewness", "minFaceWeight", "minVolRatio",
    "minTetQuality"
};


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- [deg], of what is a cosine but for rounding errors
static scalar angleOf(const scalar cosine)
{
    return radToDeg(Foam::acos(max(scalar(-1), min(cosine, scalar(1)))));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void faceQualityCounts::add
(
    const label facei,
    const faceGeometry& f,
    const FixedList<scalar, nBounds>& measures,
    const qualityControls& bounds
)
{
    const scalar angle = angleOf(measures[0]);
    const bool isBeyond[nBounds] =
    {
        angle > bounds.maxNonOrtho,
        measures[1] > bounds.maxInternalSkewness,
        measures[2] < bounds.minFaceWeight,
        measures[3] < bounds.minVolRatio,
        measures[4] > 0
    };

    ++nFaces;
    sumCosines += measures[0];
    maxNonOrtho = max(maxNonOrtho, angle);
    maxSkewness = max(maxSkewness, measures[1]);
    minWeight = min(minWeight, measures[2]);
    minVolRatio = min(minVolRatio, measures[3]);

    bool isBeyondAny = false;
    for (label k = 0; k < nBounds; ++k)
    {
        nBeyond[k] += isBeyond[k];
        isBeyondAny = isBeyondAny || isBeyond[k];
    }

    nBeyondAny += isBeyondAny;
    if (isBeyondAny && facei < firstLabel)
    {
        firstLabel = facei;
        firstPlace = f.centre;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar faceQualityCounts::meanNonOrtho() const
{
    return nFaces ? angleOf(sumCosines/nFaces) : 0;
}



void faceQualityCounts::operator+=(const faceQualityCounts& others)
{
    nFaces += others.nFaces;
    sumCosines += others.sumCosines;
    maxNonOrtho = max(maxNonOrtho, others.maxNonOrtho);
    maxSkewness = max(maxSkewness, others.maxSkewness);
    minWeight = min(minWeight, others.minWeight);
    minVolRatio = min(minVolRatio, others.minVolRatio);
    nBeyondAny += others.nBeyondAny;
    nOfWall += others.nOfWall;

    for (label k = 0; k < nBounds; ++k)
    {
        nBeyond[k] += others.nBeyond[k];
    }

    if (others.firstLabel < firstLabel)
    {
        firstLabel = others.firstLabel;
        firstPlace = others.firstPlace;
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isBelowQuality
(
    const point& a,
    const point& b,
    const point& c,
    const point& d,
    const scalar bound
)
{
    const scalar volume6 = ((b - a) ^ (c - a)) & (d - a);

    if (bound <= 0)
    {
        return volume6 < 0;
    }

    // 6 V R <= sqrt(3)/4 l^4 for the longest edge l, so that the quality is at
    // least 5178 (V/l^3)^4
    const scalar longestSqr = max
    (
        max(max(magSqr(b - a), magSqr(c - a)), magSqr(c - b)),
        max(max(magSqr(d - a), magSqr(d - b)), magSqr(d - c))
    );
    const scalar square = sqr(volume6/6)/(pow3(longestSqr) + VSMALL);

    return volume6 <= 0
     || (5178*sqr(square) < bound && tetPointRef(a, b, c, d).quality() < bound);
}


//- Add the faces between the cells of a stack, and between them and those of
//  neighbours of higher labels
static void addStack
(
    const prismLayers& layers,
    const layerGeometry& geometry,
    const qualityControls& bounds,
    const columnTeam& team,
    const label facei,
    faceQualityCounts& faces
)
{
    const face& f = layers.faces[facei];
    const auto cell = [&](const label g, const label i)
    {
        return faceCell{geometry.centres(g)[i - 1], geometry.volume3(g, i)/3};
    };

    for (label i = 1; i <= layers.nLayers; ++i)
    {
        const auto add = [&](const auto& points, const faceCell& other)
        {
            faces.add
            (
                team.wholeFace(facei), faceGeometry(points), points,
                cell(facei, i), other, bounds
            );
        };

        if (i < layers.nLayers)
        {
            add(levelPoints{layers, f, i}, cell(facei, i + 1));
        }

        forAll(f, k)
        {
            const label g = geometry.across(facei, k);
            if (g > facei)
            {
                const label before = faces.nBeyond[0];
                add(sidePoints{layers, f[k], f[f.fcIndex(k)], i}, cell(g, i));
                faces.nOfWall += faces.nBeyond[0] > before
                 && geometry.isOfWall(facei, k, i);
            }
        }
    }
}


faceQualityCounts faceQualityOfLayers
(
    const prismLayers& layers,
    const layerGeometry& geometry,
    const qualityControls& bounds,
    const columnTeam& team
)
{
    faceQualityCounts own;

    #pragma omp parallel
    {
        faceQualityCounts ofThread;

        #pragma omp for schedule(static, 64)
        forAll(layers.faces, facei)
        {
            if (team.countsFace(facei))
            {
                addStack(layers, geometry, bounds, team, facei, ofThread);
            }
        }

        #pragma omp critical
        own += ofThread;
    }

    faceQualityCounts all;
    for
    (
        const faceQualityCounts& ofProcess
      : team.gather(List<faceQualityCounts>(1, own))
    )
    {
        all += ofProcess;
    }

    return all;
}

} // End namespace Foam

// ************************************************************************* //
