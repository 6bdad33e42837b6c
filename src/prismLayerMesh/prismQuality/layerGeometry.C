/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerGeometry.H"
#include "cellGain.H"
#include "surfaceMeasures.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

cellGeometry::cellGeometry(const UList<faceGeometry>& faces)
{
    point estimate(Zero);
    for (const faceGeometry& f : faces)
    {
        estimate += f.centre/scalar(faces.size());
    }

    vector sum(Zero);
    for (const faceGeometry& f : faces)
    {
        const scalar v = f.pyramid3(estimate);
        volume3 += v;
        sum += v*(0.75*(f.centre - estimate));
    }

    centre = volume3 > VSMALL ? estimate + sum/volume3 : estimate;
}


// * * * * * * * * * * * * * * *  Stack Heights  * * * * * * * * * * * * * * //

//- A quadrilateral. Its centre is in the plane through the mean of its points,
//  normal to its area vector: for the volume of a pyramid the mean is as good.
static faceGeometry meanQuad
(
    const point& p0,
    const point& p1,
    const point& p2,
    const point& p3
)
{
    faceGeometry f;
    f.centre = 0.25*(p0 + p1 + p2 + p3);
    f.area = 0.5*((p2 - p0)^(p3 - p1));

    return f;
}


static faceGeometry levelFace(const UList<point>& points)
{
    return points.size() == 4
      ? meanQuad(points[0], points[1], points[2], points[3])
      : faceGeometry(points);
}


//- Three times the volume of the cell between two faces
static scalar volume3
(
    const UList<point>& lower,
    const UList<point>& upper,
    const faceGeometry& lowerFace,
    const faceGeometry& upperFace
)
{
    // The sum does not depend on the apex; near by, it does not round much
    const point& apex = lower[0];
    const label n = lower.size();

    scalar sum = upperFace.pyramid3(apex) - lowerFace.pyramid3(apex);

    for (label k = 0; k < n; ++k)
    {
        const label next = k + 1 < n ? k + 1 : 0;

        sum += meanQuad(lower[k], lower[next], upper[next], upper[k])
            .pyramid3(apex);
    }

    return sum;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

stackHeights::stackHeights(const prismLayers& layers)
:
    layers_(layers),
    heights_(layers.nLayers)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void stackHeights::collect
(
    const label facei,
    const label level,
    DynamicList<point>& points
) const
{
    points.clear();

    for (const label c : layers_.faces[facei])
    {
        points.append(layers_(c, level));
    }
}


void stackHeights::compute(const label facei)
{
    compute(facei, layers_.nLayers);
}


void stackHeights::compute(const label facei, const label nLayers)
{
    collect(facei, 0, lower_);
    faceGeometry lowerFace(levelFace(lower_));
    wallArea_ = mag(lowerFace.area);

    for (label i = 1; i <= nLayers; ++i)
    {
        collect(facei, i, upper_);
        const faceGeometry upperFace(levelFace(upper_));

        heights_[i - 1] = layerHeight
        (
            lowerFace, upperFace, volume3(lower_, upper_, lowerFace, upperFace)
        );

        lowerFace = upperFace;
        lower_.swap(upper_);
    }
}


// * * * * * * * * * * * * * *  Layer Geometry * * * * * * * * * * * * * * * //

//- Non-orthogonality [rad] that cells of some height may have beyond that of
//  flat ones
static const scalar wallMargin = degToRad(5.0);


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void layerGeometry::update(const label facei)
{
    visitCells
    (
        layers_, layers_.faces[facei],
        [&](const label i, const UList<faceGeometry>& faces)
        {
            const cellGeometry cell(faces);
            centres_[facei*layers_.nLayers + i - 1] = cell.centre;
            volumes3_[facei*layers_.nLayers + i - 1] = cell.volume3;
            return true;
        }
    );
}


void layerGeometry::join(const edge& e, const label a, const label b)
{
    const face& f = layers_.faces[a];
    const face& g = layers_.faces[b];
    const scalar flat = wallCosine
    (
        faceGeometry(levelPoints{layers_, f, 0}),
        faceGeometry(levelPoints{layers_, g, 0}),
        layers_(e.end(), 0) - layers_(e.start(), 0)
    );
    const scalar cosine = flat > 1
      ? GREAT : max(Foam::cos(Foam::acos(flat) + wallMargin), scalar(0));
    const auto set = [&](const face& from, const label facei, const label other)
    {
        const label k = from.edgeDirection(e) > 0
          ? from.find(e.start()) : from.find(e.end());
        across_[starts_[facei] + k] = other;
        wallCosines_[starts_[facei] + k] = cosine;
    };

    set(f, a, b);
    set(g, b, a);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

layerGeometry::layerGeometry
(
    const prismLayers& layers,
    const wallAddressing& addressing
)
:
    layers_(layers),
    starts_(layers.faces.size() + 1, Zero),
    centres_(layers.faces.size()*layers.nLayers),
    volumes3_(centres_.size())
{
    forAll(layers.faces, facei)
    {
        starts_[facei + 1] = starts_[facei] + layers.faces[facei].size();
    }
    across_.setSize(starts_.last(), -1);
    wallCosines_.setSize(starts_.last(), GREAT);

    // Each edge has places of its own in both of its faces
    #pragma omp parallel for schedule(static, 256)
    forAll(addressing.edges, e)
    {
        const labelPair& two = addressing.edgeFaces[e];
        if (two.first() >= 0 && two.second() >= 0)
        {
            join(addressing.edges[e], two.first(), two.second());
        }
    }

    update(identity(layers.faces.size()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void layerGeometry::update(const labelUList& faces)
{
    #pragma omp parallel for schedule(static, 64) if (faces.size() > 64)
    forAll(faces, i)
    {
        update(faces[i]);
    }
}


labelList layerGeometry::withNeighbours(const labelUList& faces) const
{
    DynamicList<label> all(faces);
    for (const label facei : faces)
    {
        forAll(layers_.faces[facei], k)
        {
            if (across(facei, k) >= 0)
            {
                all.append(across(facei, k));
            }
        }
    }
    inplaceUniqueSort(all);

    return labelList(std::move(all));
}


bool layerGeometry::isOfWall
(
    const label facei,
    const label k,
    const label i
) const
{
    const face& f = layers_.faces[facei];
    const faceGeometry side(sidePoints{layers_, f[k], f[f.fcIndex(k)], i});
    const vector between
    (
        centres(across(facei, k))[i - 1] - centres(facei)[i - 1]
    );

    const scalar cosine = wallCosines_[starts_[facei] + k];

    return cosine < 1 && nonOrthoViolation(side.area, between, cosine) <= 0;
}


scalar layerGeometry::gainViolations
(
    const label facei,
    const scalar target
) const
{
    const face& f = layers_.faces[facei];
    const UList<point> own(centres(facei));
    DynamicList<schemeFace> seen(f.size() + 2);
    scalar sum = 0;

    // The lower a layer, the less the gains
    scalar gain = GREAT;
    for (label i = layers_.nLayers; i > 0 && gain > 0.5*target; --i)
    {
        const auto add = [&](const faceGeometry& g, scalar sign, const point* x)
        {
            seen.append(seenFace(sign*g.area, g.centre, own[i - 1], x));
        };
        seen.clear();
        add
        (
            faceGeometry(levelPoints{layers_, f, i - 1}), -1,
            i > 1 ? &own[i - 2] : nullptr
        );
        add
        (
            faceGeometry(levelPoints{layers_, f, i}), 1,
            i < layers_.nLayers ? &own[i] : nullptr
        );
        forAll(f, k)
        {
            const label g = across(facei, k);
            add
            (
                faceGeometry(sidePoints{layers_, f[k], f[f.fcIndex(k)], i}), 1,
                g < 0 ? nullptr : &centres(g)[i - 1]
            );
        }
        gain = cellGain(seen, volume3(facei, i)/3);
        sum += sqr(gainViolation(gain, target));
    }

    return sum;
}


scalar layerGeometry::violation
(
    const label facei,
    const faceTargets& targets
) const
{
    const face& f = layers_.faces[facei];
    const UList<point> cellCentres(centres(facei));
    scalar sum = 0;
    const auto add = [&]
    (
        const auto& points,
        const point& a,
        const point* b,
        const scalar cosine
    )
    {
        const faceGeometry g(points);
        sum += sqr(planarityViolation(g, points, a, b, targets.planarity));
        if (b)
        {
            sum += sqr(nonOrthoViolation(g.area, *b - a, cosine))
              + sqr(skewnessViolation(g, points, a, *b, targets.skewness));
        }
    };

    for (label i = 1; i <= layers_.nLayers; ++i)
    {
        add
        (
            levelPoints{layers_, f, i}, cellCentres[i - 1],
            i < layers_.nLayers ? &cellCentres[i] : nullptr, targets.cosine
        );
    }

    forAll(f, k)
    {
        const label g = across(facei, k);
        for (label i = 1; i <= layers_.nLayers; ++i)
        {
            add
            (
                sidePoints{layers_, f[k], f[f.fcIndex(k)], i},
                cellCentres[i - 1],
                g < 0 ? nullptr : &centres(g)[i - 1],
                targetCosine(facei, k, targets)
            );
        }
    }

    return sum;
}

} // End namespace Foam

// ************************************************************************* //
