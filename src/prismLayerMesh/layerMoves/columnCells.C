/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnCells.H"
#include "layerGeometry.H"
#include "scaledJacobian.H"

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
                columnSide
                {
                    a, b, a == column || b == column, j, other,
                    g < 0 || other >= 0
                  ? pointField() : pointField(geometry.centres(g)),
                    List<faceGeometry>(layers_.nLayers)
                }
            );
            for (label i = 1; !sides_.last().moves && i <= layers_.nLayers; ++i)
            {
                updateSide(sides_.size() - 1, i);
            }
        }
    }
}


void columnCells::updateLevel(const label stacki, const label i)
{
    columnStack& s = stacks_[stacki];
    s.levels[i] = faceGeometry(levelPoints{layers_, s.columns, i});
}


void columnCells::updateSide(const label sidei, const label i)
{
    columnSide& s = sides_[sidei];
    s.faces[i - 1] = faceGeometry(sidePoints{layers_, s.a, s.b, i});
}


void columnCells::updateCell(const label stacki, const label i)
{
    columnStack& s = stacks_[stacki];
    cellFaces_.clear();
    cellFaces_.append(s.levels[i - 1]);
    cellFaces_[0].area *= -1;
    cellFaces_.append(s.levels[i]);
    forAll(s.sides, k)
    {
        cellFaces_.append(sides_[s.sides[k]].faces[i - 1]);
        cellFaces_.last().area *= s.outwards[k] ? 1 : -1;
    }

    const cellGeometry cell(cellFaces_);
    s.centres[i - 1] = cell.centre;
    s.volumes3[i - 1] = cell.volume3;
}


void columnCells::update()
{
    forAll(sides_, sidei)
    {
        for (label i = 1; sides_[sidei].moves && i <= layers_.nLayers; ++i)
        {
            updateSide(sidei, i);
        }
    }

    forAll(stacks_, stacki)
    {
        for (label i = 1; i <= layers_.nLayers; ++i)
        {
            updateLevel(stacki, i);
            updateCell(stacki, i);
        }
    }
}


scalar columnCells::heightError(const scalar height, const scalar kept) const
{
    const scalar error = height/kept - 1;
    const scalar slack = controls_.heightSlack;

    return error - max(-slack, min(error, slack));
}


FixedList<scalar, 2> columnCells::heightResiduals
(
    const columnStack& s,
    const scalar firstHeight,
    const scalar thickness
) const
{
    const scalar error = heightError(firstHeight, s.keptHeights[0]);
    const scalar weight = targets_.firstHeightWeight;
    const scalar excess = max(error - (controls_.maxExcess - 1), scalar(0));

    return
    {
        weight*error + (controls_.firstHeightWeight - weight)*excess,
        targets_.thicknessWeight*heightError(thickness, sum(s.keptHeights))
    };
}


scalar columnCells::sumOfFaces()
{
    missedLevels_.clear();
    missedSides_.clear();
    nFacesWithoutDecomposition_ = 0;

    const auto square = [&]
    (
        const faceGeometry& f,
        const auto& points,
        const point& owner,
        const point* neighbour
    )
    {
        const vector r(residualsOf(f, points, owner, neighbour));

        // A face that meets the stricter target also meets this one
        nFacesWithoutDecomposition_ +=
            (r.z() > 0 || targets_.faces.planarity < SMALL)
         && planarityViolation(f, points, owner, neighbour, SMALL) > 0;

        return magSqr(r);
    };

    scalar sum = 0;
    forAll(stacks_, stacki)
    {
        for (label i = 1; i <= layers_.nLayers; ++i)
        {
            const scalar s = onLevel(stacks_[stacki], i, square);
            if (s > 0)
            {
                missedLevels_.append(labelPair(stacki, i));
                sum += s;
            }
        }
    }

    forAll(sides_, sidei)
    {
        for (label i = 1; i <= layers_.nLayers; ++i)
        {
            const scalar s = onSide(sides_[sidei], i, square);
            if (s > 0)
            {
                missedSides_.append(labelPair(sidei, i));
                sum += s;
            }
        }
    }

    return sum;
}


scalar columnCells::jacobianResidual(const columnStack& s, const label i) const
{
    return controls_.jacobianWeight
       *jacobianViolation(layers_, s.columns, i, targets_.jacobian(s.facei));
}


scalar columnCells::gainResidual(const labelPair& cell) const
{
    const scalar gain = gainOf(stacks_, sides_, cell);

    return targets_.gainWeight*gainViolation(gain, targets_.gain);
}


scalar columnCells::sumOfGains()
{
    missedGains_.clear();
    for (label stacki = 0; !watches_ && stacki < stacks_.size(); ++stacki)
    {
        // The lower a layer, the less the gains
        labelPair cell(stacki, layers_.nLayers);
        while
        (
            cell.second() > 0
         && gainOf(stacks_, sides_, cell) > 0.5*targets_.gain
        )
        {
            watchedGains_.append(cell);
            --cell.second();
        }
    }
    watches_ = true;

    scalar sum = 0;
    for (const labelPair& cell : watchedGains_)
    {
        const scalar residual = gainResidual(cell);
        if (residual > 0)
        {
            missedGains_.append(cell);
            sum += sqr(residual);
        }
    }

    return sum;
}


scalar columnCells::sumOfCells()
{
    missedCells_.clear();
    scalar sum = 0;

    forAll(stacks_, stacki)
    {
        const columnStack& s = stacks_[stacki];
        const bool misses = targets_.missesJacobian(layers_, s.facei);

        for (label i = 1; misses && i <= layers_.nLayers; ++i)
        {
            const scalar residual = jacobianResidual(s, i);
            if (residual > 0)
            {
                missedCells_.append(labelPair(stacki, i));
                sum += sqr(residual);
            }
        }
    }

    return sum;
}


FixedList<vector, 2> columnCells::displacements() const
{
    const label n = layers_.nLayers;
    const label half = (n + 1)/2;
    const scalar height = mag(places_.last() - layers_(column_, 0));

    return
    {
        (layers_(column_, half) - places_[half - 1])/height,
        (layers_(column_, n) - places_[n - 1])/height
    };
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
            columnStack
            {
                facei, f, targets.heights[facei],
                labelList(f.size()), boolList(f.size()),
                List<faceGeometry>(n + 1), pointField(n), scalarField(n)
            }
        );
        updateLevel(stacks_.size() - 1, 0);
    }

    addSides(geometry, around, column);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar columnCells::evaluate()
{
    update();
    scalar sum = sumOfFaces() + sumOfCells();
    sum += targets_.gain < GREAT ? sumOfGains() : 0;

    for (columnStack& s : stacks_)
    {
        if (s.keptHeights.size())
        {
            setHeights(s);
            const auto errors = heightResiduals(s, s.firstHeight, s.thickness);
            sum += sqr(errors[0]) + sqr(errors[1]);
        }
    }

    for (const vector& d : displacements())
    {
        sum += sqr(controls_.displacementWeight)*magSqr(d);
    }

    return sum;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void columnCells::findMoved()
{
    movedLevels_.clear();
    movedSides_.clear();
    for (const labelPair& cell : movedCells_)
    {
        const label i = cell.second();
        movedLevels_.append(cell);
        if (i > 1)
        {
            movedLevels_.append(labelPair(cell.first(), i - 1));
        }
        for (const label sidei : stacks_[cell.first()].sides)
        {
            if (sides_[sidei].moves)
            {
                movedSides_.append(labelPair(sidei, i));
            }
        }
    }
    inplaceUniqueSort(movedLevels_);
    inplaceUniqueSort(movedSides_);
}


void columnCells::linearise()
{
    const label n = layers_.nLayers;
    linearAt_ = SubList<point>(layers_.points, n, layers_.index(column_, 1));

    for (columnStack& s : stacks_)
    {
        if (s.keptHeights.size())
        {
            setGradients(layers_, sides_, column_, s);
        }
    }

    movedCells_.clear();
    for (const labelPair& level : missedLevels_)
    {
        movedCells_.append(level);
        if (level.second() < n)
        {
            movedCells_.append(labelPair(level.first(), level.second() + 1));
        }
    }
    for (const labelPair& missed : missedSides_)
    {
        const columnSide& s = sides_[missed.first()];
        movedCells_.append(labelPair(s.first, missed.second()));
        if (s.second >= 0)
        {
            movedCells_.append(labelPair(s.second, missed.second()));
        }
    }
    for (const labelPair& missed : missedGains_)
    {
        const label i = missed.second();
        for (label j = max(i - 1, 1); j <= min(i + 1, n); ++j)
        {
            movedCells_.append(labelPair(missed.first(), j));
        }
        for (const label sidei : stacks_[missed.first()].sides)
        {
            movedCells_.append(labelPair(sides_[sidei].first, i));
            if (sides_[sidei].second >= 0)
            {
                movedCells_.append(labelPair(sides_[sidei].second, i));
            }
        }
    }
    inplaceUniqueSort(movedCells_);
    findMoved();
}


void columnCells::updateMoved()
{
    for (const labelPair& level : movedLevels_)
    {
        updateLevel(level.first(), level.second());
    }
    for (const labelPair& side : movedSides_)
    {
        updateSide(side.first(), side.second());
    }
    for (const labelPair& cell : movedCells_)
    {
        updateCell(cell.first(), cell.second());
    }
}


void columnCells::residuals(DynamicList<scalar>& all)
{
    updateMoved();

    all.clear();
    for (const columnStack& s : stacks_)
    {
        if (s.keptHeights.size())
        {
            const vector first(layers_(column_, 1) - linearAt_[0]);
            scalar thickness = s.thickness;
            forAll(linearAt_, i)
            {
                thickness +=
                    s.gradients[i] & (layers_(column_, i + 1) - linearAt_[i]);
            }
            all.append
            (
                heightResiduals
                (
                    s, s.firstHeight + (s.firstGradient & first), thickness
                )
            );
        }
    }

    const auto append = [&](const vector& r)
    {
        all.append(r.x());
        all.append(r.y());
        all.append(r.z());
    };
    const auto residualsOf = [&](const auto&... face)
    {
        return this->residualsOf(face...);
    };
    for (const labelPair& level : missedLevels_)
    {
        append(onLevel(stacks_[level.first()], level.second(), residualsOf));
    }
    for (const labelPair& side : missedSides_)
    {
        append(onSide(sides_[side.first()], side.second(), residualsOf));
    }
    for (const labelPair& cell : missedCells_)
    {
        all.append(jacobianResidual(stacks_[cell.first()], cell.second()));
    }
    for (const labelPair& cell : missedGains_)
    {
        all.append(gainResidual(cell));
    }
    for (const vector& d : displacements())
    {
        append(controls_.displacementWeight*d);
    }
}

} // End namespace Foam

// ************************************************************************* //
