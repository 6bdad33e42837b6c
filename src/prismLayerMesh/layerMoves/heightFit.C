/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include <Eigen/SparseCholesky>

#include "heightFit.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

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

} // End namespace Foam


// * * * * * * * * * * * * * * Private Classes * * * * * * * * * * * * * * * //

struct Foam::heightFit::factors
{
    scalarField mobilities;
    sparseMatrix a;
    Eigen::SimplicialLDLT<sparseMatrix> inverse;
};


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::heightFit::heightFit
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


Foam::heightFit::~heightFit() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::heightFit::setMobilities(const scalarField& mobilities)
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


Foam::vectorField Foam::heightFit::displacements
(
    const scalarField& lacking
) const
{
    const Eigen::Map<const Eigen::VectorXd> r(lacking.cdata(), lacking.size());
    const Eigen::VectorXd d
    (
        factors_->a.transpose()*factors_->inverse.solve(r)
    );

    vectorField result(d.size()/3);
    forAll(result, c)
    {
        result[c] = ::sqrt(factors_->mobilities[c])
           *vector(d[3*c], d[3*c + 1], d[3*c + 2]);
    }

    return result;
}


// ************************************************************************* //
