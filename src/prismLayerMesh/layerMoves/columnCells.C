/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnCells.H"
#include "stackHeights.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void columnCells::addSides
(
    const layerGeometry& geometry,
    const labelUList& around,
    const label column
)
{
    forAll(around, j)
    {
        const face& f = stacks_[j].columns;
        forAll(f, k)
        {
            const label g = geometry.across(around[j], k);
            const label other = g < 0 ? -1 : around.find(g);
            const label a = f[k];
            const label b = f[f.fcIndex(k)];

            if (other >= 0 && other < j)
            {
                // The earlier stack has it, the other way round
                const face& h = stacks_[other].columns;
                stacks_[j].sides[k] = stacks_[other].sides[h.find(b)];
                stacks_[j].outwards[k] = false;
                continue;
            }

            stacks_[j].sides[k] = sides_.size();
            stacks_[j].outwards[k] = true;
            sides_.append
            (
                side
                {
                    a, b, a == column || b == column, j, other,
                    g < 0 || other >= 0
                  ? pointField() : pointField(geometry.centres(g)),
                    List<faceGeometry>(layers_.nLayers)
                }
            );
            for (label i = 1; i <= layers_.nLayers; ++i)
            {
                sides_.last().faces[i - 1] =
                    faceGeometry(sidePoints{layers_, a, b, i});
            }
        }
    }
}


void columnCells::updateCells(stack& s) const
{
    const label n = s.columns.size();
    List<faceGeometry> faces(n + 2);

    for (label i = 1; i <= layers_.nLayers; ++i)
    {
        faces[0] = s.levels[i - 1];
        faces[0].area *= -1;
        faces[1] = s.levels[i];
        for (label k = 0; k < n; ++k)
        {
            faces[2 + k] = sides_[s.sides[k]].faces[i - 1];
            faces[2 + k].area *= s.outwards[k] ? 1 : -1;
        }

        const cellGeometry cell(faces);
        s.centres[i - 1] = cell.centre;
        s.volumes3[i - 1] = cell.volume3;
    }
}


scalar columnCells::heightError(const scalar height, const scalar kept) const
{
    const scalar error = height/kept - 1;
    const scalar slack = controls_.heightSlack;

    return error - max(-slack, min(error, slack));
}


const UList<point>& columnCells::neighbourCentres(const side& s) const
{
    return s.second < 0 ? s.fixedCentres : stacks_[s.second].centres;
}


scalar columnCells::levelViolation
(
    const stack& s,
    const label i,
    const scalar target
) const
{
    return planarityViolation
    (
        s.levels[i], levelPoints{layers_, s.columns, i}, s.centres[i - 1],
        i < layers_.nLayers ? &s.centres[i] : nullptr, target
    );
}


scalar columnCells::sideViolation
(
    const side& s,
    const label i,
    const scalar target
) const
{
    const UList<point>& other = neighbourCentres(s);

    return planarityViolation
    (
        s.faces[i - 1], sidePoints{layers_, s.a, s.b, i},
        stacks_[s.first].centres[i - 1],
        other.size() ? &other[i - 1] : nullptr, target
    );
}


void columnCells::addViolations(DynamicList<scalar>& residuals) const
{
    const faceTargets& targets = targets_.faces;

    const auto add = [&]
    (
        const faceGeometry& f,
        const auto& points,
        const point& a,
        const point& b
    )
    {
        residuals.append(nonOrthoViolation(f.area, b - a, targets.cosine));
        residuals.append(skewnessViolation(f, points, a, b, targets.skewness));
    };

    for (const stack& s : stacks_)
    {
        for (label i = 1; i < layers_.nLayers; ++i)
        {
            add
            (
                s.levels[i], levelPoints{layers_, s.columns, i},
                s.centres[i - 1], s.centres[i]
            );
        }
        for (label i = 1; i <= layers_.nLayers && s.columns.size() == 4; ++i)
        {
            residuals.append
            (
                controls_.planarityWeight
               *levelViolation(s, i, targets.planarity)
            );
        }
    }

    for (const side& s : sides_)
    {
        const UList<point>& other = neighbourCentres(s);
        for (label i = 1; i <= other.size(); ++i)
        {
            add
            (
                s.faces[i - 1], sidePoints{layers_, s.a, s.b, i},
                stacks_[s.first].centres[i - 1], other[i - 1]
            );
        }
        for (label i = 1; i <= layers_.nLayers; ++i)
        {
            residuals.append
            (
                controls_.planarityWeight
               *sideViolation(s, i, targets.planarity)
            );
        }
    }
}


void columnCells::addDisplacements(DynamicList<scalar>& residuals) const
{
    const label n = layers_.nLayers;
    const scalar height = mag(places_.last() - layers_(column_, 0));

    for (const label i : {(n + 1)/2, n})
    {
        const vector d((layers_(column_, i) - places_[i - 1])/height);
        for (direction k = 0; k < vector::nComponents; ++k)
        {
            residuals.append(controls_.displacementWeight*d[k]);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

columnCells::columnCells
(
    const layerEditor& editor,
    const layerGeometry& geometry,
    const bendTargets& targets,
    const label column
)
:
    layers_(editor.layers()),
    targets_(targets),
    controls_(editor.controls()),
    column_(column),
    places_(targets.places[column])
{
    const labelList& around = editor.front().addressing.pointFaces[column];
    const label n = layers_.nLayers;

    for (const label facei : around)
    {
        const face& f = layers_.faces[facei];
        stacks_.append
        (
            stack
            {
                f, targets.heights[facei],
                labelList(f.size()), boolList(f.size()),
                List<faceGeometry>(n + 1), pointField(n), scalarField(n)
            }
        );
        stacks_.last().levels[0] = faceGeometry(levelPoints{layers_, f, 0});
    }

    addSides(geometry, around, column);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar columnCells::evaluate(DynamicList<scalar>& residuals)
{
    residuals.clear();

    for (side& s : sides_)
    {
        for (label i = 1; s.moves && i <= layers_.nLayers; ++i)
        {
            s.faces[i - 1] = faceGeometry(sidePoints{layers_, s.a, s.b, i});
        }
    }

    for (stack& s : stacks_)
    {
        for (label i = 1; i <= layers_.nLayers; ++i)
        {
            s.levels[i] = faceGeometry(levelPoints{layers_, s.columns, i});
        }
        updateCells(s);

        // The first height, and the thickness
        if (s.heights.size())
        {
            scalar thickness = 0;
            forAll(s.heights, i)
            {
                const scalar height =
                    layerHeight(s.levels[i], s.levels[i + 1], s.volumes3[i]);
                thickness += height;
                if (i == 0)
                {
                    const scalar error = heightError(height, s.heights[0]);
                    const scalar weight = targets_.firstHeightWeight;
                    residuals.append
                    (
                        weight*error
                      + (controls_.firstHeightWeight - weight)
                       *max(error - (controls_.maxExcess - 1), scalar(0))
                    );
                }
            }
            residuals.append
            (
                targets_.thicknessWeight*heightError(thickness, sum(s.heights))
            );
        }
    }

    addViolations(residuals);
    addDisplacements(residuals);

    scalar sum = 0;
    for (const scalar r : residuals)
    {
        sum += sqr(r);
    }

    return sum;
}


label columnCells::nFacesWithoutDecomposition() const
{
    label n = 0;

    for (const stack& s : stacks_)
    {
        for (label i = 1; i <= layers_.nLayers && s.columns.size() == 4; ++i)
        {
            n += levelViolation(s, i, SMALL) > 0;
        }
    }

    for (const side& s : sides_)
    {
        for (label i = 1; i <= layers_.nLayers; ++i)
        {
            n += sideViolation(s, i, SMALL) > 0;
        }
    }

    return n;
}

} // End namespace Foam

// ************************************************************************* //
