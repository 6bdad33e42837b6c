/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    checkPrismLayers

Group
    grpMeshManipulationUtilities

Description
    The certificate of harmonicPrismMesh for a mesh that any program has made.

    A mesh is certified if all cells are closed and positive, wall and outer
    surface together do not intersect themselves, every face of the wall has as
    many layers as are asked for, no two faces have the same points, and the
    cells fill the boundary. Predicates are exact, but for polyhedra beside
    refined cells. Otherwise the exit status is 1.

Usage
    \b checkPrismLayers [OPTIONS]

    Options:
      - \par -region \<name\>
        Check the mesh of that region

      - \par -walls \<wordRes\>
        Patches with layers; default those on which a stack of layers stands, if
        a cellZone boundaryLayer or an outer patch tells; else all of type wall

      - \par -outer \<wordRes\>
        Patches of the outer surface of the layers; default layerOuter. Without
        an outer surface no intersections are looked for.

      - \par -layers \<n\>|\<dictionary\>
        Ask for n layers on every face of the walls, or for numbers of layers by
        patch: 'body 3; "wing.*" 5;'. Patches of type wall that are named here
        are walls with layers.

      - \par -plainScheme
        Solve heat conduction by the plain scheme "Gauss linear corrected", with
        gradients by Gauss linear and by leastSquares: print by how much an
        iteration multiplies the error, the place of the mode that decays least,
        and the explicit gains of the cells; write the cells of the mode as
        cellSets plainSchemeMode and leastSquaresMode

      - \par -version
        Print the version, and do nothing else

      - \par -writeSets
        Write the cells that are not positive as cellSet nonPositiveCells

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "cellSet.H"
#include "certificateLog.H"
#include "explicitGains.H"
#include "layeredWalls.H"
#include "patchOptions.H"
#include "plainScheme.H"
#include "pluginVersion.H"
#include "polyMesh.H"
#include "prismPolyMesh.H"
#include "returnMemory.H"
#include "sigFpe.H"
#include "Time.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- Iterations of the plain scheme
static const label nPlainIterations = 60;


static label count(const scalarField& values, const scalar bound)
{
    return std::count_if
    (
        values.begin(), values.end(), [&](scalar x) { return x > bound; }
    );
}


static void addOptions()
{
    argList::noParallel();
    argList::addNote
    (
        "Check the prism layers of any mesh by exact predicates:\n"
        "cells are positive, wall and outer surface do not intersect, layers"
        " are complete, the cells fill the boundary."
    );
    argList::addOption("region", "name", "Check the mesh of that region");
    argList::addOption
    (
        "walls",
        "wordRes",
        "Patches with layers, eg, '(body \"wing.*\")'."
        " Default: patches on which layers stand"
    );
    argList::addOption
    (
        "outer",
        "wordRes",
        "Patches of the outer surface of the layers."
        " Default: layerOuter, if it exists"
    );
    argList::addOption
    (
        "layers",
        "n|dictionary",
        "Ask for n layers on every face of the walls, or by patch, eg,"
        " 'body 3; \"wing.*\" 5;'"
    );
    argList::addBoolOption
    (
        "plainScheme",
        "Solve heat conduction by the plain scheme, Gauss linear corrected,"
        " with gradients by Gauss linear and by leastSquares."
        " Print by how much an iteration multiplies the error, and write the"
        " cells that converge last as a cellSet"
    );
    argList::addBoolOption("version", "Print the version, do nothing else");
    argList::addBoolOption
    (
        "writeSets", "Write the cells that are not positive as a cellSet"
    );
}


static void writeSet
(
    const polyMesh& mesh,
    const word& name,
    const labelUList& cells
)
{
    cellSet set(mesh, name, cells);
    set.instance() = mesh.facesInstance();

    if (!set.write())
    {
        FatalErrorInFunction
            << "Cannot write " << set.objectPath() << exit(FatalError);
    }

    Info<< nl << "Set: " << set.objectPath() << endl;
}


//- Tests the plain scheme with some gradients, and logs the result
static void solve
(
    const polyMesh& mesh,
    const std::string& gradients,
    const word& setName
)
{
    const plainScheme tested
    (
        testPlainScheme(mesh, gradients, nPlainIterations)
    );
    Info<< nl << "Plain scheme (Gauss linear corrected), gradients by "
        << gradients.c_str() << nl;
    if (tested.failure.size())
    {
        Info<< "    NOT TESTED: " << tested.failure.c_str() << endl;
        return;
    }

    const labelList cells(tested.cellsOfMode(0.5));
    Info<< "    factor " << tested.factor << ": "
        << (tested.factor < 1 ? "converges" : "DIVERGES") << nl
        << "    half of the mode that decays least is in " << cells.size()
        << " cells, first at " << mesh.cellCentres()[cells[0]] << endl;

    writeSet(mesh, setName, cells);
}


static void writeGains(const polyMesh& mesh)
{
    const scalarField gains(guardedGains(mesh));
    const scalar large = schemeGrade::largeGain;

    Info<< nl << "Explicit gains: largest " << max(gains) << " at "
        << mesh.cellCentres()[findMax(gains)] << ", above 1 "
        << count(gains, 1) << ", above " << name(large) << ' '
        << count(gains, large) << " cells" << endl;
}


static void end(const bool certified)
{
    Info<< nl << (certified ? "Certified" : "NOT certified") << nl << endl;

    // What main returns is lost: the destructor of args exits with 0
    if (!certified)
    {
        UPstream::exit(1);
    }
}


//- Errors: FatalError if a coordinate is not finite, or so large that products
//  of coordinates are not
static autoPtr<polyMesh> readMesh(const argList& args, const Time& runTime)
{
    const scalar largest = 1e70;

    // A comparison with a coordinate that is no number must not end the program
    const sigFpe::ignore noTraps;
    autoPtr<polyMesh> mesh
    (
        new polyMesh
        (
            IOobject
            (
                args.lookupOrDefault<word>("region", polyMesh::defaultRegion),
                runTime.timeName(), runTime, IOobject::MUST_READ
            )
        )
    );
    if (!mesh->nCells())
    {
        FatalErrorInFunction << "The mesh has no cells" << exit(FatalError);
    }
    forAll(mesh->points(), pointi)
    {
        const point& p = mesh->points()[pointi];
        if (!(mag(p.x()) + mag(p.y()) + mag(p.z()) < largest))
        {
            FatalErrorInFunction
                << "Point " << pointi << " of the mesh is at " << p
                << ". Coordinates must be finite, and less than " << largest
                << " m" << exit(FatalError);
        }
    }

    return mesh;
}


//- The cells that are not in the zone of the layers; none without that zone
static bitSet beyondLayers(const polyMesh& mesh)
{
    bitSet beyond;
    const label zonei = mesh.cellZones().findZoneID(boundaryLayerName);
    if (zonei >= 0)
    {
        beyond = bitSet(mesh.nCells(), true);
        beyond.unset(mesh.cellZones()[zonei]);
    }

    return beyond;
}


//- Does what -plainScheme and -writeSets ask for
static void writeOptional
(
    const argList& args,
    const polyMesh& mesh,
    const labelUList& invalidCells
)
{
    if (args.found("plainScheme"))
    {
        writeGains(mesh);
        solve(mesh, "Gauss linear", "plainSchemeMode");
        solve(mesh, "leastSquares", "leastSquaresMode");
    }

    if (args.found("writeSets"))
    {
        writeSet(mesh, "nonPositiveCells", invalidCells);
    }
}


int main(int argc, char *argv[])
{
    waitPassively(argv);
    if (versionIsAsked(argc, argv))
    {
        return 0;
    }
    addOptions();

    #include "setRootCase.H"
    #include "createTime.H"

    const autoPtr<polyMesh> read(readMesh(args, runTime));
    const polyMesh& mesh = read();

    const polyBoundaryMesh& boundary = mesh.boundaryMesh();
    const bitSet beyond(beyondLayers(mesh));
    const polyhedralMesh cells
    (
        mesh.points(), mesh.faces(), mesh.faceOwner(), mesh.faceNeighbour()
    );
    const namedPatches named(readPatchOptions(args, boundary, cells, beyond));
    const labelList wallFaces(facesOf(boundary, named.walls));
    const labelList outerFaces(facesOf(boundary, named.outer));
    meshCertificate certificate
    (
        certifyMesh(cells, wallFaces, outerFaces, beyond)
    );
    leaveOutSides(cells, wallFaces, beyond, outerFaces, certificate.nLayers);

    writeCells(certificate, cells);
    writeIntersections(certificate, mesh, named.outer);
    writeWhole(certificate, mesh);
    const bool complete =
        writeLayers(certificate, mesh, named.walls, named.layersAsked)
     && (wallFaces.size() || !args.found("layers"));

    writeOptional(args, mesh, certificate.invalidCells);

    end
    (
        certificate.invalidCells.empty()
     && certificate.intersections.empty()
     && certificate.doubleFaces.empty()
     && certificate.fillsBoundary()
     && complete
    );

    return 0;
}


// ************************************************************************* //
