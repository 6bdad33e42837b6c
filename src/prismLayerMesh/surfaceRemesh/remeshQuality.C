/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshQuality.H"
#include "Pair.H"
#include "edgeHashes.H"
#include "surfaceMeasures.H"
#include "unitConversion.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Triangles between features are not counted if they are narrower than this
//  share of minEdge: two edges as long as that have angles of 14 degrees there
static constexpr scalar narrowShare = 0.25;


namespace
{

struct featuresOf
{
    edgeHashSet edges;
    boolList hasPoint;
};

} // End anonymous namespace


static featuresOf findFeatures
(
    const wallSurface& surface,
    const wallSides& all,
    const vectorField& normals,
    const scalar minCos
)
{
    featuresOf features{{}, boolList(surface.points.size(), false)};

    for (label e = 0; e < all.nEdges(); ++e)
    {
        const label start = all.edgeStarts[e];
        const wallSide& a = all.sides[start];
        const wallSide& b = all.sides[all.edgeStarts[e + 1] - 1];

        if
        (
            all.edgeStarts[e + 1] - start != 2
         || surface.patchIDs[a.facei] != surface.patchIDs[b.facei]
         || (normals[a.facei] & normals[b.facei]) < minCos
        )
        {
            features.edges.insert(edge(a.low, a.high));
            features.hasPoint[a.low] = true;
            features.hasPoint[a.high] = true;
        }
    }

    return features;
}


//- Whether a face is a triangle from one feature to another that is narrower
static bool isNarrow
(
    const face& f,
    const pointField& points,
    const featuresOf& features,
    const scalar minWidth
)
{
    const scalar base = f.faceEdge(f.longestEdge(points)).mag(points);
    bool isBetween = f.size() == 3 && 2*f.mag(points) < minWidth*base;
    for (const label p : f)
    {
        isBetween = isBetween && features.hasPoint[p];
    }

    return isBetween;
}


//- Whether a face has small angles between two features, and others
static Pair<bool> smallAngles
(
    const face& f,
    const pointField& points,
    const featuresOf& features
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
                features.edges.found(before) && features.edges.found(after);
            (isFeature ? result.first() : result.second()) = true;
        }
    }

    return result;
}


static bool isNonOrthogonal
(
    const vector& edgeVector,
    const vector& normal,
    const vector& betweenCentres
)
{
    static const scalar least = Foam::cos(degToRad(remeshQuality::nonOrtho));
    const vector across(edgeVector ^ normal);

    return
        mag(betweenCentres & across) < least*mag(betweenCentres)*mag(across);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

remeshQuality qualityAwayFromFeatures
(
    const wallSurface& surface,
    const surfaceRemeshControls& controls
)
{
    const pointField& points = surface.points;
    const vectorField normals(surface.faceNormals());
    const wallSides all(makeWallSides(surface.faces, points.size()));
    const featuresOf features
    (
        findFeatures
        (
            surface, all, normals, Foam::cos(degToRad(controls.featureAngle))
        )
    );
    remeshQuality result;
    boolList isOfFeatures(surface.faces.size());

    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        const Pair<bool> small(smallAngles(f, points, features));
        const bool narrow =
            isNarrow(f, points, features, narrowShare*controls.minEdge);
        isOfFeatures[facei] = narrow || small.first();
        result.nSmallAngles += !narrow && small.second();
    }

    for (label e = 0; e < all.nEdges(); ++e)
    {
        const wallSide& a = all.sides[all.edgeStarts[e]];
        const label other = all.sides[all.edgeStarts[e + 1] - 1].facei;
        const edge both(a.low, a.high);
        result.nNonOrtho +=
            !features.edges.found(both)
         && !isOfFeatures[a.facei] && !isOfFeatures[other]
         && isNonOrthogonal
            (
                both.vec(points),
                normals[a.facei] + normals[other],
                surface.faces[other].centre(points)
              - surface.faces[a.facei].centre(points)
            );
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
