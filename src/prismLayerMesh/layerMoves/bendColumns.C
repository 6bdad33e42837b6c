/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bendColumns.H"
#include "columnCells.H"
#include "layerGeometry.H"
#include "ranges.H"
#include "scaledJacobian.H"
#include "unitConversion.H"

#include <Eigen/Dense>

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bendTargets bendTargets::withMargins
(
    const layerMoveControls& controls,
    const scalarField& attainable
)
{
    const qualityControls& quality = controls.quality;

    bendTargets targets;
    targets.faces.cosine =
        Foam::cos(degToRad(quality.maxNonOrtho - controls.angleMargin));
    targets.faces.skewness = controls.skewnessShare*quality.maxInternalSkewness;
    targets.faces.planarity = controls.targetPlanarity;
    targets.jacobians =
        min(controls.targetJacobian, controls.jacobianShare*attainable);
    targets.gain = controls.targetGain;
    targets.gainWeight = controls.gainWeight;
    targets.firstHeightWeight = controls.firstHeightWeight;
    targets.thicknessWeight = controls.thicknessWeight;

    return targets;
}


bool bendTargets::missesJacobian
(
    const prismLayers& layers,
    const label facei
) const
{
    const scalar target = jacobian(facei);

    return target > 0 && worstJacobian(layers, facei, target) < target;
}


void bendTargets::keep(const layerEditor& editor, const labelUList& columns)
{
    const labelListList& pointFaces = editor.front().addressing.pointFaces;
    DynamicList<label> newStacks;

    for (const label c : columns)
    {
        if (places.insert(c, pointField()))
        {
            places[c] = editor.state(c).points;
        }

        for (const label facei : pointFaces[c])
        {
            if
            (
                heights.insert(facei, scalarField())
             && facei < editor.front().nWallFaces
            )
            {
                newStacks.append(facei);
            }
        }
    }

    #pragma omp parallel for schedule(static, 64) if (newStacks.size() > 64)
    forAll(newStacks, i)
    {
        stackHeights stack(editor.layers());
        stack.compute(newStacks[i]);
        heights[newStacks[i]] = stack.heights();
    }
}


labelList stacksMissingTargets
(
    const prismLayers& layers,
    const layerGeometry& geometry,
    const labelUList& faces,
    const bendTargets& targets
)
{
    boolList missesTargets(faces.size());

    #pragma omp parallel for schedule(dynamic, 64) if (faces.size() > 64)
    forAll(faces, i)
    {
        missesTargets[i] =
            targets.missesJacobian(layers, faces[i])
         ||
            (
                targets.faces.any()
             && geometry.violation(faces[i], targets.faces) > 0
            )
         ||
            (
                targets.gain < GREAT
             && geometry.gainViolations(faces[i], targets.gain) > 0
            );
    }

    return subset(missesTargets, labelList(faces));
}


// * * * * * * * * * * * * * * *  Bend Columns * * * * * * * * * * * * * * * //

//- Shapes, as functions of the share of the height, in which a column moves
static constexpr label nShapes = 4;

//- Each in three directions
static constexpr label nUnknowns = 3*nShapes;

typedef Eigen::Matrix<scalar, nUnknowns, 1> bendVector;

//- Step of differences, over the height of the column
static constexpr scalar differenceStep = 0.02;

//- Damping of Levenberg and Marquardt that is tried, in this order, over the
//  mean of the diagonal
static constexpr scalar dampings[] = {0.01, 0.1, 1, 10};


namespace
{

//- A column that moves from where it is
class bentColumn
{
    layerEditor& editor_;
    const label c_;
    const columnState& before_;

    //- Lengths that a column of unit displacement in a shape moves, by level
    List<FixedList<scalar, nShapes>> shapes_;

public:

    bentColumn(layerEditor& editor, const label c, const columnState& before)
    :
        editor_(editor),
        c_(c),
        before_(before),
        shapes_(before_.points.size())
    {
        const point& root = editor.layers()(c, 0);
        const scalar full = mag(before_.points.last() - root);

        forAll(shapes_, i)
        {
            // Lean, bend, and bulges near to the wall
            const scalar height = mag(before_.points[i] - root);
            const scalar t = height/full;
            const scalar u = scalar(i)/shapes_.size();
            shapes_[i] =
                {height, height*t, height*sqr(1 - t), height*pow4(1 - u)};
        }
    }

    void displace(const bendVector& x)
    {
        forAll(shapes_, i)
        {
            vector d(Zero);
            for (label k = 0; k < nShapes; ++k)
            {
                d += shapes_[i][k]*vector(x[3*k], x[3*k + 1], x[3*k + 2]);
            }
            editor_.setPoint(c_, i + 1, before_.points[i] + d);
        }
    }

    void restore()
    {
        editor_.restore(c_, before_);
    }
};


//- Normal equations of a step of Gauss and Newton
struct normalEquations
{
    Eigen::Matrix<scalar, nUnknowns, nUnknowns> matrix;
    bendVector source;
};

}


//- From differences of the residuals. Leaves the column displaced.
static normalEquations linearise(bentColumn& column, columnCells& cells)
{
    typedef Eigen::Matrix<scalar, Eigen::Dynamic, nUnknowns> jacobian;
    DynamicList<scalar> residuals, moved;
    cells.linearise();
    cells.residuals(residuals);

    const label n = residuals.size();
    const Eigen::Map<const Eigen::VectorXd> r(residuals.cdata(), n);
    jacobian J(n, label(nUnknowns));

    for (label k = 0; k < nUnknowns; ++k)
    {
        column.displace(differenceStep*bendVector::Unit(k));
        cells.residuals(moved);
        J.col(k) = Eigen::Map<const Eigen::VectorXd>(moved.cdata(), n) - r;
    }
    J /= differenceStep;

    return normalEquations{J.transpose()*J, -J.transpose()*r};
}


//- Bend one column. False if it stays.
static bool bend
(
    layerEditor& editor,
    const layerGeometry& geometry,
    const bendTargets& targets,
    const label c,
    const columnState& before,
    const std::function<bool(label)>& isAtFault
)
{
    const layerMoveControls& controls = editor.controls();
    columnCells cells(editor, geometry, targets, c);
    const scalar sum = cells.evaluate();

    if (sum <= 0)
    {
        return false;
    }

    bentColumn column(editor, c, before);
    const label nFacesWithoutDecomposition = cells.nFacesWithoutDecomposition();
    const normalEquations step(linearise(column, cells));
    const labelList& around = editor.front().addressing.pointFaces[c];

    for (const scalar damping : dampings)
    {
        auto matrix(step.matrix);
        matrix.diagonal().array() +=
            damping*step.matrix.trace()/nUnknowns + VSMALL;
        bendVector x(matrix.ldlt().solve(step.source));
        x *= min
        (
            scalar(1), controls.maxBend/max(x.cwiseAbs().maxCoeff(), VSMALL)
        );
        column.displace(x);

        if
        (
            cells.evaluate() <= controls.bendGain*sum
         && cells.nFacesWithoutDecomposition() <= nFacesWithoutDecomposition
         && !anyOf(around, isAtFault)
        )
        {
            return true;
        }
    }

    column.restore();

    return false;
}


labelList bendColumns
(
    layerEditor& editor,
    editedGeometry& geometry,
    const bendTargets& targets,
    const labelUList& columns,
    const std::function<bool(label)>& isAtFault
)
{
    const layerGeometry* current = nullptr;

    return editor.inColours
    (
        columns,
        [&]() { current = &geometry.now(); },
        [&](const label c, const columnState& before)
        {
            return bend(editor, *current, targets, c, before, isAtFault);
        }
    );
}

} // End namespace Foam

// ************************************************************************* //
