/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnCells.H"
#include "stackHeights.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void columnCells::setGradients(stack& s) const
{
    const label k = s.columns.find(column_);
    const label before = s.columns.rcIndex(k);
    s.gradients.setSize(layers_.nLayers);
    s.gradients = Zero;

    // Three times the volume changes by three times the area of each face times
    // the mean displacement of its points
    const scalar share = 3.0/s.columns.size();
    vector areaBelow(Zero);

    forAll(s.volumes3, i)
    {
        const faceGeometry& lower = s.levels[i];
        const faceGeometry& upper = s.levels[i + 1];
        const vector across
        (
            layers_(s.columns[before], i + 1)
          - layers_(s.columns[s.columns.fcIndex(k)], i + 1)
        );
        const vector along(normalised(upper.area));
        const vector area(0.5*(along ^ across));
        vector sides(Zero);
        for (const label j : {before, k})
        {
            sides += (s.outwards[j] ? 0.75 : -0.75)
               *sides_[s.sides[j]].faces[i].area;
        }

        const scalar height = layerHeight(lower, upper, s.volumes3[i]);
        const scalar areas =
            max(mag(lower.area) + mag(upper.area), VSMALL);
        s.gradients[i] +=
            (2.0/3.0*(sides + share*upper.area) - height*area)/areas;

        if (i == 0)
        {
            s.firstGradient = s.gradients[0];
        }
        else
        {
            s.gradients[i - 1] +=
                (2.0/3.0*(sides - share*lower.area) - height*areaBelow)/areas;
        }
        areaBelow = area;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void columnCells::linearise()
{
    const label n = layers_.nLayers;
    linearAt_ = SubList<point>(layers_.points, n, layers_.index(column_, 1));

    for (stack& s : stacks_)
    {
        if (s.keptHeights.size())
        {
            setGradients(s);
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
        const side& s = sides_[missed.first()];
        movedCells_.append(labelPair(s.first, missed.second()));
        if (s.second >= 0)
        {
            movedCells_.append(labelPair(s.second, missed.second()));
        }
    }
    inplaceUniqueSort(movedCells_);

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
    for (const stack& s : stacks_)
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
    for (const vector& d : displacements())
    {
        append(controls_.displacementWeight*d);
    }
}

} // End namespace Foam

// ************************************************************************* //
