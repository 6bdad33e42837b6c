/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshSurface.H"
#include "bitSet.H"
#include "edgeHashes.H"
#include "Pair.H"
#include "surfaceMeasures.H"
#include "UIndirectList.H"
#include "unitConversion.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Triangles between features are not counted if they are narrower than this
//  share of minEdge: two edges as long as that have angles of 14 degrees there
static constexpr scalar narrowShare = 0.25;


//- Whether a face is a triangle from one feature to another that is narrower
static bool isNarrow
(
    const face& f,
    const pointField& points,
    const bitSet& onFeatures,
    const scalar minWidth
)
{
    const scalar base = f.faceEdge(f.longestEdge(points)).mag(points);
    bool isBetween = f.size() == 3 && 2*f.mag(points) < minWidth*base;
    for (const label p : f)
    {
        isBetween = isBetween && onFeatures.test(p);
    }

    return isBetween;
}


//- Whether a face has small angles between two features, and others
static Pair<bool> smallAngles
(
    const face& f,
    const pointField& points,
    const edgeHashSet& features
)
{
    static const scalar largestCos =
        Foam::cos(degToRad(surfaceMeasures::smallAngle));
    Pair<bool> result(false, false);

    forAll(f, k)
    {
        const edge before(f.prevLabel(k), f[k]);
        const edge after(f[k], f.nextLabel(k));
        const vector a(points[before.start()] - points[f[k]]);
        const vector b(points[after.end()] - points[f[k]]);
        if ((a & b) > largestCos*mag(a)*mag(b))
        {
            const bool isFeature =
                features.found(before) && features.found(after);
            (isFeature ? result.first() : result.second()) = true;
        }
    }

    return result;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

remeshQuality qualityAwayFromFeatures
(
    const wallSurface& surface,
    const edgeList& features,
    const scalar minEdge
)
{
    const pointField& points = surface.points;
    const edgeHashSet isFeature(features);
    bitSet onFeatures(points.size());
    for (const edge& e : features)
    {
        onFeatures.set(e.start());
        onFeatures.set(e.end());
    }

    remeshQuality result;
    boolList isOfFeatures(surface.faces.size());
    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        const Pair<bool> small(smallAngles(f, points, isFeature));
        const bool narrow =
            isNarrow(f, points, onFeatures, narrowShare*minEdge);
        isOfFeatures[facei] = narrow || small.first();
        result.nSmallAngles += !narrow && small.second();
    }

    static const scalar least = Foam::cos(degToRad(remeshQuality::nonOrtho));
    const auto geometry = [&](const label facei)
    {
        return faceGeometry(UIndirectList<point>(points, surface.faces[facei]));
    };
    const wallSides all(makeWallSides(surface.faces, points.size()));
    for (label e = 0; e < all.nEdges(); ++e)
    {
        const wallSide& a = all.on(e)[0];
        const label other = all.on(e).last().facei;
        const edge both(a.low, a.high);
        result.nNonOrtho +=
            !isFeature.found(both)
         && !isOfFeatures[a.facei] && !isOfFeatures[other]
         && wallCosine(geometry(a.facei), geometry(other), both.vec(points))
          < least;
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
