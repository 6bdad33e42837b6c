/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <Eigen/SparseCore>
#include <Eigen/IterativeLinearSolvers>

#include "harmonicField.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef Eigen::SparseMatrix<double, Eigen::RowMajor> sparseMatrix;


namespace
{

//- Equations for the free points
struct linearSystem
{
    sparseMatrix matrix;
    Eigen::VectorXd source;
};

} // End anonymous namespace


static linearSystem assemble
(
    const backgroundMesh& mesh,
    const scalarField& weights,
    const labelList& unknowns,
    const scalarField& field
)
{
    const labelList row(invert(mesh.points.size(), unknowns));
    linearSystem system;
    system.source = Eigen::VectorXd::Zero(unknowns.size());

    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4*mesh.edges.size());

    forAll(mesh.edges, e)
    {
        const label a = mesh.edges[e].start(), b = mesh.edges[e].end();
        const scalar w = weights[e];

        for (const labelPair& ij : {labelPair(a, b), labelPair(b, a)})
        {
            const label i = row[ij.first()], j = row[ij.second()];

            if (i >= 0)
            {
                entries.emplace_back(i, i, w);

                if (j >= 0)
                {
                    entries.emplace_back(i, j, -w);
                }
                else
                {
                    system.source[i] += w*field[ij.second()];
                }
            }
        }
    }

    system.matrix.resize(unknowns.size(), unknowns.size());
    system.matrix.setFromTriplets(entries.begin(), entries.end());

    return system;
}


static void solveKrylov
(
    const backgroundMesh& mesh,
    const scalarField& weights,
    const scalar tolerance,
    scalarField& field
)
{
    const labelList unknowns(findIndices(mesh.free, true));
    const linearSystem system(assemble(mesh, weights, unknowns, field));

    Eigen::ConjugateGradient<sparseMatrix, Eigen::Lower|Eigen::Upper> solver;
    solver.setTolerance(tolerance);
    solver.compute(system.matrix);

    const Eigen::VectorXd solution = solver.solveWithGuess
    (
        system.source, Eigen::VectorXd::Constant(unknowns.size(), 0.5)
    );

    if (unknowns.size() && solver.info() != Eigen::Success)
    {
        FatalErrorInFunction
            << "No convergence after " << label(solver.iterations())
            << " iterations: residual " << solver.error()
            << ", tolerance " << tolerance << exit(FatalError);
    }

    forAll(unknowns, i)
    {
        field[unknowns[i]] = solution[i];
    }
}


//- Algorithm 1. Its line 6 is printed the wrong way round: iteration goes on
//  while the energy still changes.
static void iterate
(
    const backgroundMesh& mesh,
    const scalarField& weights,
    const scalar tolerance,
    scalarField& field
)
{
    labelListList pointEdges;
    invertManyToMany(mesh.points.size(), mesh.edges, pointEdges);
    const label maxIterations = harmonicControls::maxIterations;

    scalar energy = harmonicEnergy(mesh, weights, field);
    scalar previous = 0;

    for (label i = 0; i < maxIterations; ++i)
    {
        if (mag(energy - previous) <= tolerance*energy)
        {
            return;
        }

        forAll(field, p)
        {
            if (mesh.free[p])
            {
                scalar sumWeights = 0, sumValues = 0;

                for (const label e : pointEdges[p])
                {
                    sumWeights += weights[e];
                    sumValues +=
                        weights[e]*field[mesh.edges[e].otherVertex(p)];
                }

                // Positive, except at a point that no tetrahedron uses
                if (sumWeights > 0)
                {
                    field[p] = sumValues/sumWeights;
                }
            }
        }

        previous = energy;
        energy = harmonicEnergy(mesh, weights, field);
    }

    FatalErrorInFunction
        << "No convergence after " << maxIterations
        << " iterations: energy " << energy << ", last change "
        << mag(energy - previous) << exit(FatalError);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalarField cotangentWeights(const backgroundMesh& mesh)
{
    const symmTensor one(symmTensor::I);

    return conductivityWeights(mesh, symmTensorField(mesh.tets.size(), one));
}


scalarField conductivityWeights
(
    const backgroundMesh& mesh,
    const symmTensorField& conductivities
)
{
    scalarField weights(mesh.edges.size(), 0);

    forAll(mesh.tets, t)
    {
        const FixedList<vector, 4> g(tetAreas(mesh.tet(t)).gradients());
        const symmTensor K(mesh.tet(t).mag()*conductivities[t]);

        label k = 0;
        for (label i = 0; i < 4; ++i)
        {
            for (label j = i + 1; j < 4; ++j, ++k)
            {
                weights[mesh.tetEdges[t][k]] -= g[i] & K & g[j];
            }
        }
    }

    return weights;
}


scalarField makeHarmonicField
(
    const backgroundMesh& mesh,
    const scalarField& edgeWeights,
    const fieldControls& controls
)
{
    scalarField field(mesh.wallIndicator());

    if (controls.solver == fieldSolver::iteration)
    {
        iterate(mesh, edgeWeights, controls.tolerance, field);
    }
    else
    {
        solveKrylov(mesh, edgeWeights, controls.tolerance, field);
    }

    return field;
}


scalar harmonicEnergy
(
    const backgroundMesh& mesh,
    const scalarField& edgeWeights,
    const scalarField& field
)
{
    scalar energy = 0;

    forAll(mesh.edges, e)
    {
        energy += edgeWeights[e]
           *sqr(field[mesh.edges[e].start()] - field[mesh.edges[e].end()]);
    }

    return energy;
}

} // End namespace Foam

// ************************************************************************* //
