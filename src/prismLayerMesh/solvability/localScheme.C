/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localScheme.H"
#include "Random.H"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

//- Iterations; the factor is the geometric mean of the second half
static const label nPowerIterations = 60;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef Eigen::SparseMatrix<scalar> sparseMatrix;


//- The lower half of the implicit matrix
static sparseMatrix implicitMatrix
(
    const label n,
    const UList<localSchemeFace>& faces
)
{
    std::vector<Eigen::Triplet<scalar>> entries;
    for (const localSchemeFace& f : faces)
    {
        const scalar coefficient = f.face.implicit;
        entries.emplace_back(f.own, f.own, coefficient);
        if (f.other >= 0)
        {
            entries.emplace_back(f.other, f.other, coefficient);
            entries.emplace_back
            (
                max(f.own, f.other), min(f.own, f.other), -coefficient
            );
        }
    }
    sparseMatrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());

    return matrix;
}


//- The explicit matrix times values; gradients is for work
static Eigen::VectorXd explicitly
(
    const Eigen::VectorXd& values,
    const UList<localSchemeFace>& faces,
    const scalarField& volumes,
    vectorField& gradients
)
{
    gradients = Zero;
    for (const localSchemeFace& f : faces)
    {
        scalar value = f.face.ownShare*values[f.own];
        if (f.other >= 0)
        {
            value += f.face.otherShare*values[f.other];
            gradients[f.other] -= value/volumes[f.other]*f.face.area;
        }
        gradients[f.own] += value/volumes[f.own]*f.face.area;
    }

    Eigen::VectorXd source(Eigen::VectorXd::Zero(values.size()));
    for (const localSchemeFace& f : faces)
    {
        vector gradient(f.face.ownShare*gradients[f.own]);
        if (f.other >= 0)
        {
            gradient += f.face.otherShare*gradients[f.other];
        }
        const scalar flux = f.face.explicitArea & gradient;
        source[f.own] += flux;
        if (f.other >= 0)
        {
            source[f.other] -= flux;
        }
    }

    return source;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

schemeMode localScheme::slowestMode() const
{
    const label n = volumes_.size();
    const Eigen::SimplicialLLT<sparseMatrix> implicit
    (
        implicitMatrix(n, faces_)
    );

    Random random(1);
    Eigen::VectorXd values(n);
    for (label i = 0; i < n; ++i)
    {
        values[i] = random.sample01<scalar>() - 0.5;
    }
    values.normalize();

    vectorField gradients(n);
    scalar logSum = 0;
    for (label k = 0; k < nPowerIterations; ++k)
    {
        values = implicit.solve
        (
            explicitly(values, faces_, volumes_, gradients)
        ).eval();
        const scalar size = max(values.norm(), VSMALL);
        values /= size;
        logSum += 2*k >= nPowerIterations ? std::log(size) : 0;
    }

    schemeMode mode;
    mode.factor = std::exp(2*logSum/nPowerIterations);
    mode.values = scalarField(UList<scalar>(values.data(), n));

    return mode;
}

} // End namespace Foam

// ************************************************************************* //
