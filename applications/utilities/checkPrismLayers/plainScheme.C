/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "plainScheme.H"
#include "explicitGains.H"
#include "fixedValueFvPatchFields.H"
#include "fvcGrad.H"
#include "fvMatrices.H"
#include "fvMesh.H"
#include "fvmLaplacian.H"
#include "isolatedProcess.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Random.H"
#include "ranges.H"
#include "StringStream.H"
#include "throwingErrors.H"
#include "Time.H"
#include "volFields.H"

#include <cmath>
#include <sstream>

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


//- Small meshes, which GAMG refuses to make coarser, have no coarser levels
static dictionary solverFor(const fvMesh& mesh)
{
    const label small = 1000;

    return parsed
    (
        std::string
        (
            mesh.nCells() < small
          ? "solver PCG; preconditioner DIC;"
          : "solver GAMG; smoother DICGaussSeidel; nCellsInCoarsestLevel 100;"
        )
      + " tolerance 1e-14; relTol 0.01; minIter 1;"
    );
}


static bool hasFixedValue(const volScalarField& T)
{
    return anyOf
    (
        T.boundaryField(),
        [](const fvPatchScalarField& p) { return p.size() && p.fixesValue(); }
    );
}


//- Errors: FatalError that names the first cell without a finite gradient
static void requireGradients(const volScalarField& T)
{
    const tmp<volVectorField> gradients(fvc::grad(T));
    forAll(gradients(), celli)
    {
        if (!std::isfinite(magSqr(gradients()[celli])))
        {
            FatalErrorInFunction
                << "the gradient in cell " << celli << " at "
                << T.mesh().C()[celli] << " is not finite"
                << exit(FatalError);
        }
    }
}


//- Solves for T, so many times, or until T is 0: the initial error is then the
//  mode. Returns by how much an iteration multiplies T, as the geometric mean
//  of the second half.
//  Errors: FatalError if T is not finite
static scalar iterate(const label nIterations, volScalarField& T)
{
    const dictionary solver(solverFor(T.mesh()));
    const bool forceReference = !hasFixedValue(T);
    if (forceReference && !T.mesh().nInternalFaces())
    {
        FatalErrorInFunction
            << "no face fixes a value or is between cells" << exit(FatalError);
    }
    requireGradients(T);
    lduMatrix::debug = 0;
    solverPerformance::debug = 0;

    scalar logSum = 0;
    label nSummed = 0;
    for (label i = 0; i < nIterations; ++i)
    {
        const scalarField last(T.primitiveField());
        T.correctBoundaryConditions();
        fvScalarMatrix equation(fvm::laplacian(T));
        equation.setReference(0, 0, forceReference);
        equation.solve(solver);
        const scalar factor = normalise(T.primitiveFieldRef());
        if (!std::isfinite(factor))
        {
            FatalErrorInFunction
                << "the solution of iteration " << i + 1 << " is not finite"
                << exit(FatalError);
        }
        if (factor <= VSMALL)
        {
            T.primitiveFieldRef() = last;
            return 0;
        }
        if (2*i >= nIterations)
        {
            logSum += Foam::log(factor);
            ++nSummed;
        }
    }

    return Foam::exp(logSum/max(nSummed, label(1)));
}


//- Solves in a case in a folder
static plainScheme solveIn(const fileName& folder, const label nIterations)
{
    Time time
    (
        parsed("deltaT 1; endTime 1; writeFrequency 1;"),
        folder.path(), folder.name(), "system", "constant", false
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

    plainScheme tested;
    tested.factor = iterate(nIterations, T);
    tested.mode = T.primitiveField();

    return tested;
}


//- A message of OpenFOAM in one line
static std::string inOneLine(const std::string& message)
{
    std::istringstream words(message);
    std::string line;
    for (std::string next; words >> next; )
    {
        line += (line.empty() ? "" : " ") + next;
    }

    return line;
}


//- As solveIn, with errors of OpenFOAM as the failure of the result
static plainScheme solveGuarded
(
    const fileName& folder,
    const label nIterations
)
{
    const throwingErrors throwing(true);
    plainScheme tested;
    try
    {
        tested = solveIn(folder, nIterations);
    }
    catch (const Foam::error& e)
    {
        tested.failure = inOneLine(e.message());
    }
    catch (const std::exception& e)
    {
        tested.failure = e.what();
    }

    return tested;
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

    plainScheme tested;
    const processEnd end = isolatedProcess
    (
        [&](pipeWriter& write)
        {
            const plainScheme s(solveGuarded(folder.path(), nIterations));
            write(s.factor, s.mode, s.failure);
        },
        [&](pipeReader& read)
        {
            read(tested.factor, tested.mode, tested.failure);
        }
    );
    if (end != processEnd::complete)
    {
        tested.failure = "the process that solves ended without a result";
    }

    return tested;
}


Foam::scalarField Foam::guardedGains(const polyMesh& mesh)
{
    const finiteVolumes volumes(volumesOf(mesh));
    scalarField gains;
    const processEnd end = isolatedProcess
    (
        [&](pipeWriter& write) { write(explicitGains(volumes)); },
        [&](pipeReader& read) { read(gains); }
    );
    if (end != processEnd::complete)
    {
        gains = scalarField(mesh.nCells(), invalidGain);
    }

    for (scalar& gain : gains)
    {
        gain = std::isfinite(gain) ? gain : invalidGain;
    }

    return gains;
}


// ************************************************************************* //
