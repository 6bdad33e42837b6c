/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicField.H"
#include "ListOps.H"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

namespace Foam
{

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
            << "The harmonic field does not converge in "
            << label(solver.iterations()) << " iterations: residual "
            << solver.error() << ", field.tolerance " << tolerance
            << exit(FatalError);
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
                    sumValues += weights[e]*field[mesh.edges[e].otherVertex(p)];
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
        << "The harmonic field does not converge in " << maxIterations
        << " iterations: energy " << energy << ", last change "
        << mag(energy - previous) << ", field.tolerance " << tolerance
        << ". field.solver krylov converges faster" << exit(FatalError);
}


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


// * * * * * * * * * * * * * *  Field Gradients  * * * * * * * * * * * * * * //

//- Solid angle of the triangle that three unit vectors span on the sphere
static scalar solidAngle(const vector& a, const vector& b, const vector& c)
{
    return 2*::atan2(mag((a ^ b) & c), 1 + (a & b) + (b & c) + (c & a));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

tetAreas::tetAreas(const tetPointRef& tet)
{
    const vector ab = tet.b() - tet.a();
    const vector ac = tet.c() - tet.a();
    const vector ad = tet.d() - tet.a();

    normals[0] = ac ^ ad;
    normals[1] = ad ^ ab;
    normals[2] = ab ^ ac;
    sixV = max
    (
        normals[2] & ad, harmonicControls::smallestShape*mag(ab)*mag(ac)*mag(ad)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

FixedList<vector, 4> tetAreas::gradients() const
{
    FixedList<vector, 4> gradients;

    for (label i = 1; i < 4; ++i)
    {
        gradients[i] = normals[i - 1]/sixV;
    }
    gradients[0] = -(gradients[1] + gradients[2] + gradients[3]);

    return gradients;
}


vectorField tetGradients(const backgroundMesh& mesh, const scalarField& field)
{
    vectorField gradients(mesh.tets.size());
    forAll(mesh.tets, t)
    {
        const FixedList<vector, 4> g(tetAreas(mesh.tet(t)).gradients());

        gradients[t] = Zero;
        for (label i = 0; i < 4; ++i)
        {
            gradients[t] += field[mesh.tets[t][i]]*g[i];
        }
    }

    return gradients;
}


gradientMeans pointGradientMeans
(
    const backgroundMesh& mesh,
    const scalarField& field
)
{
    const vectorField tetGradient(tetGradients(mesh, field));
    const scalarField tetSize(mag(tetGradient));

    gradientMeans means;
    means.gradients.setSize(mesh.points.size(), Zero);
    means.sizes.setSize(mesh.points.size(), 0);
    scalarField angles(mesh.points.size(), 0);
    forAll(mesh.tets, t)
    {
        const tetCell& tet = mesh.tets[t];

        for (label i = 0; i < 4; ++i)
        {
            const point& x = mesh.points[tet[i]];
            const scalar angle = solidAngle
            (
                normalised(mesh.points[tet[(i + 1) % 4]] - x),
                normalised(mesh.points[tet[(i + 2) % 4]] - x),
                normalised(mesh.points[tet[(i + 3) % 4]] - x)
            );

            means.gradients[tet[i]] += angle*tetGradient[t];
            means.sizes[tet[i]] += angle*tetSize[t];
            angles[tet[i]] += angle;
        }
    }

    means.gradients /= max(angles, VSMALL);
    means.sizes /= max(angles, VSMALL);

    return means;
}


vectorField pointGradients(const backgroundMesh& mesh, const scalarField& field)
{
    return pointGradientMeans(mesh, field).gradients;
}


// * * * * * * * * * * * * * *  Monotone Field * * * * * * * * * * * * * * * //

//- Free points whose values exceed all those of their neighbours, or fall
//  below, by more than tolerance
static boolList extremaOf
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const scalar tolerance
)
{
    scalarField smallest(field.size(), GREAT), largest(field.size(), -GREAT);
    for (const edge& e : mesh.edges)
    {
        for (const label p : {e.start(), e.end()})
        {
            const scalar other = field[e.otherVertex(p)];
            smallest[p] = min(smallest[p], other);
            largest[p] = max(largest[p], other);
        }
    }

    boolList extrema(field.size(), false);
    forAll(extrema, p)
    {
        extrema[p] = mesh.free[p] && smallest[p] <= largest[p]
         && (
                field[p] > largest[p] + tolerance
             || field[p] < smallest[p] - tolerance
            );
    }

    return extrema;
}


monotoneField makeMonotoneField
(
    const backgroundMesh& mesh,
    scalarField edgeWeights,
    const fieldControls& controls
)
{
    monotoneField field;
    bool changed = true;

    while (changed)
    {
        field.values = makeHarmonicField(mesh, edgeWeights, controls);
        const boolList extrema
        (
            extremaOf(mesh, field.values, controls.tolerance)
        );
        changed = false;

        forAll(mesh.edges, e)
        {
            const edge& ends = mesh.edges[e];

            if
            (
                edgeWeights[e] < 0
             && (extrema[ends.start()] || extrema[ends.end()])
            )
            {
                edgeWeights[e] = 0;
                ++field.nClipped;
                changed = true;
            }
        }
    }

    return field;
}

} // End namespace Foam

// ************************************************************************* //
