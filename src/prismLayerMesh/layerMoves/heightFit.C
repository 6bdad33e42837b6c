/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <Eigen/SparseCholesky>

#include "heightFit.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef Eigen::SparseMatrix<double> sparseMatrix;


//- A.sqrt(M): three columns for each column of the layers
static sparseMatrix heightsOfDisplacements
(
    const wallSurface& wall,
    const labelUList& faces,
    const scalarField& mobilities
)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12*faces.size());

    forAll(faces, i)
    {
        const face& f = wall.faces[faces[i]];
        const vector n(normalised(f.areaNormal(wall.points))/f.size());

        for (const label c : f)
        {
            const scalar mobility = ::sqrt(mobilities[c]);

            for (direction d = 0; d < 3; ++d)
            {
                entries.emplace_back(i, 3*c + d, mobility*n[d]);
            }
        }
    }

    sparseMatrix a(faces.size(), 3*wall.points.size());
    a.setFromTriplets(entries.begin(), entries.end());

    return a;
}


static sparseMatrix damped(const sparseMatrix& a, const scalar lambda)
{
    sparseMatrix identity(a.rows(), a.rows());
    identity.setIdentity();

    return a*sparseMatrix(a.transpose()) + lambda*identity;
}


// * * * * * * * * * * * * * * Private Classes * * * * * * * * * * * * * * * //

struct heightFit::factors
{
    scalarField mobilities;
    sparseMatrix a;
    Eigen::SimplicialLDLT<sparseMatrix> inverse;
};


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

heightFit::heightFit
(
    const wallSurface& wall,
    const labelUList& faces,
    const scalar lambda
)
:
    wall_(wall),
    faces_(faces),
    lambda_(lambda),
    factors_(new factors)
{}


heightFit::~heightFit() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void heightFit::setMobilities(const scalarField& mobilities)
{
    const bool first = factors_->mobilities.empty();
    factors_->mobilities = mobilities;
    factors_->a = heightsOfDisplacements(wall_, faces_, mobilities);

    const sparseMatrix product(damped(factors_->a, lambda_));

    if (first)
    {
        factors_->inverse.analyzePattern(product);
    }
    factors_->inverse.factorize(product);
}


vectorField heightFit::displacements(const scalarField& missing) const
{
    const Eigen::Map<const Eigen::VectorXd> r(missing.cdata(), missing.size());
    const Eigen::VectorXd d(factors_->a.transpose()*factors_->inverse.solve(r));

    vectorField result(d.size()/3);
    forAll(result, c)
    {
        result[c] = ::sqrt(factors_->mobilities[c])
           *vector(d[3*c], d[3*c + 1], d[3*c + 2]);
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
