/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "plainScheme.H"
#include "fixedValueFvPatchFields.H"
#include "fvMatrices.H"
#include "fvMesh.H"
#include "fvmLaplacian.H"
#include "isolatedProcess.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Random.H"
#include "StringStream.H"
#include "Time.H"
#include "volFields.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static dictionary parsed(const std::string& text)
{
    IStringStream is(text);

    return dictionary(is);
}


static void writeDictionary(const fileName& file, const std::string& text)
{
    OFstream os(file);
    os  << "FoamFile { version 2.0; format ascii; class dictionary; object "
        << file.name() << "; }" << nl << text.c_str() << nl;
}


//- Makes a case in a folder: the mesh, by links to its files, and schemes
static void makeCase
(
    const polyMesh& mesh,
    const std::string& gradients,
    const fileName& folder
)
{
    const fileName system(folder/"system");
    const fileName meshFolder(folder/"constant"/polyMesh::meshSubDir);
    mkDir(system);
    mkDir(meshFolder);

    const Time& time = mesh.time();
    const fileName faces
    (
        time.path()/mesh.facesInstance()/mesh.meshDir()
    );
    for (const fileName& file : readDir(faces, fileName::FILE))
    {
        if (file != "points")
        {
            ln(faces/file, meshFolder/file);
        }
    }
    const fileName points
    (
        time.path()/mesh.pointsInstance()/mesh.meshDir()/"points"
    );
    ln(points, meshFolder/"points");

    writeDictionary
    (
        system/"fvSchemes",
        std::string("ddtSchemes { default steadyState; }")
      + " gradSchemes { default " + gradients + "; }"
      + " divSchemes { default none; }"
        " laplacianSchemes { default Gauss linear corrected; }"
        " interpolationSchemes { default linear; }"
        " snGradSchemes { default corrected; }"
    );
    writeDictionary(system/"fvSolution", "solvers {}");
}


//- Fixed values on patches, except those whose type says what a field has there
static wordList patchFieldTypes(const fvMesh& mesh)
{
    wordList types(mesh.boundary().size(), "fixedValue");
    forAll(mesh.boundary(), patchi)
    {
        const word& type = mesh.boundary()[patchi].type();
        if (fvPatch::constraintType(type))
        {
            types[patchi] = type;
        }
    }

    return types;
}


//- Makes the sum of squares of a field 1. Returns the root of what it was.
static scalar normalise(scalarField& field)
{
    const scalar size = Foam::sqrt(sumSqr(field));
    field /= max(size, VSMALL);

    return size;
}


//- Solves for T, so many times. Returns by how much an iteration multiplies T,
//  as the geometric mean of the second half
static scalar iterate(const label nIterations, volScalarField& T)
{
    const dictionary solver
    (
        parsed
        (
            "solver GAMG; smoother DICGaussSeidel; tolerance 1e-14;"
            " relTol 0.01; minIter 1; nCellsInCoarsestLevel 100;"
        )
    );
    lduMatrix::debug = 0;
    solverPerformance::debug = 0;

    scalar logSum = 0;
    label nSummed = 0;
    for (label i = 0; i < nIterations; ++i)
    {
        T.correctBoundaryConditions();
        fvScalarMatrix equation(fvm::laplacian(T));
        equation.solve(solver);
        const scalar factor = normalise(T.primitiveFieldRef());
        if (2*i >= nIterations)
        {
            logSum += Foam::log(max(factor, VSMALL));
            ++nSummed;
        }
    }

    return Foam::exp(logSum/max(nSummed, label(1)));
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::plainScheme::cellsOfMode(const scalar share) const
{
    labelList order;
    sortedOrder(scalarField(-mag(mode)), order);

    scalar sum = 0;
    label n = 0;
    while (n < order.size() && sum < share)
    {
        sum += sqr(mode[order[n]]);
        ++n;
    }
    order.setSize(n);

    return order;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::plainScheme Foam::testPlainScheme
(
    const polyMesh& given,
    const std::string& gradients,
    const label nIterations
)
{
    const scratchFolder folder;
    makeCase(given, gradients, folder.path());

    Time time
    (
        parsed("deltaT 1; endTime 1; writeFrequency 1;"),
        folder.path().path(), folder.path().name(), "system", "constant", false
    );
    fvMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion, time.timeName(), time, IOobject::MUST_READ
        )
    );
    volScalarField T
    (
        IOobject("T", time.timeName(), mesh), mesh,
        dimensionedScalar("zero", dimless, 0), patchFieldTypes(mesh)
    );

    Random random(1);
    for (scalar& value : T.primitiveFieldRef())
    {
        value = random.sample01<scalar>() - 0.5;
    }
    normalise(T.primitiveFieldRef());

    const scalar factor = iterate(nIterations, T);

    return plainScheme{factor, T.primitiveField()};
}


// ************************************************************************* //
