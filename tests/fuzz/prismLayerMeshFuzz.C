/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    prismLayerMeshFuzz

Description
    Makes layers on random surfaces and checks the meshes, each in a process of
    its own. Prints a line for each failure, and for each mesh that had to do
    without a field; at the end one line with the cases of each kind, as
    failed/run. Exits with 1 if any failed.

Usage
    \b prismLayerMeshFuzz [OPTION]

      - \par -seed \<s\>
        Another seed makes other surfaces; default 1

      - \par -count \<n\>
        Number of cases, default 150

      - \par -seconds \<t\>
        Run until the time is over instead

      - \par -kind \<name\>
        All cases of that kind of surface; without it of all kinds in turn

      - \par -needles
        Closed surfaces get thin triangles

      - \par -remesh
        Closed surfaces get new triangles first

      - \par -repair \<method\>
        Closed surfaces are damaged first, and repaired: stitch or wrap

      - \par -assemblies
        Solids that touch and overlap, which repair stitch unites

      - \par -farField
        Surfaces are smaller, and have random far fields around their layers:
        hexahedra, or the cells of random meshes, and tetrahedra. At the end
        lines with the far fields of each kind, as refused/made, with the
        reasons, and what faces at the cuts are like.

      - \par -polygons
        As -farField, and meshes of polygons are made of layers and far
        fields; with -sides, -cyclic, -regions or -sheets of those

      - \par -sides
        One to three bodies that the sides of a far field's box cut, touch, or
        are near to. Each gets a mesh, or is refused before the layers, with
        the place and the entry. At the end lines as with -farField.

      - \par -regions
        Solids that touch and overlap, in a box that cuts or touches some: each
        part of space is a region, and some have layers. The meshes are joined.

      - \par -sheets
        Sheets of no thickness in a box, as baffles of its regions

      - \par -index \<i\>
        That case alone, in this process

      - \par -folder \<path\>
        Write the surfaces of failures, or that of the index, there, and the
        meshes around their layers

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "clockTime.H"
#include "fuzzCase.H"
#include "fuzzTally.H"
#include "OSspecific.H"
#include "Pstream.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- CPU time [s] of a case; those of these sizes take a second or two
static const unsigned cpuSeconds = 90;


static void addOptions()
{
    argList::noBanner();
    argList::noParallel();
    argList::noJobInfo();
    argList::noFunctionObjects();
    argList::addNote("Make layers on random surfaces and check the meshes.");
    argList::addOption("seed", "s", "Seed of all cases (default: 1)");
    argList::addOption("count", "n", "Number of cases (default: 150)");
    argList::addOption("seconds", "t", "Run until the time is over instead");
    argList::addOption
    (
        "kind", "name", "All cases of that kind of surface (default: in turn)"
    );
    argList::addBoolOption("needles", "Closed surfaces get thin triangles");
    argList::addBoolOption("remesh", "Closed surfaces get new triangles first");
    argList::addOption
    (
        "repair", "method",
        "Closed surfaces are damaged first, and repaired: stitch or wrap"
    );
    argList::addBoolOption
    (
        "assemblies", "Solids that touch and overlap, united by repair stitch"
    );
    argList::addBoolOption
    (
        "farField", "Far fields around layers on smaller surfaces"
    );
    argList::addBoolOption
    (
        "polygons", "As farField, or sides, cyclic, regions, with polygons"
    );
    argList::addBoolOption
    (
        "sides", "Bodies through, on and near the sides of a far field's box"
    );
    argList::addBoolOption
    (
        "regions", "Solids that touch and overlap, in a box, as regions"
    );
    argList::addBoolOption
    (
        "sheets", "Sheets of no thickness in a box, as baffles of a region"
    );
    argList::addBoolOption
    (
        "cyclic", "Bodies through, on and near cyclic sides of such a box"
    );
    argList::addOption("index", "i", "That case alone, in this process");
    argList::addOption
    (
        "folder", "path", "Write the surfaces of failures, or that of the index"
        ", there as OBJ"
    );
}


static void write(const fuzzCase& one, const fileName& folder)
{
    if (folder.size())
    {
        mkDir(folder);
        writeSurface
        (
            one,
            folder/(Foam::name(one.seed) + '-' + Foam::name(one.index) + ".obj")
        );
    }
}


static void report
(
    const fuzzCase& one,
    const fuzzResult& result,
    const fileName& folder
)
{
    const bool failed = result.what == fuzzResult::verdict::failed;

    if (!failed && result.noField.empty())
    {
        return;
    }

    Info<< (failed ? "FAIL" : "no field") << " -seed " << one.seed
        << " -index " << one.index << " ("
        << randomSurfaces::name(one.kind) << ") "
        << (failed ? result.cause : result.noField).c_str() << endl;

    if (failed)
    {
        write(one, folder);
    }
}


//- The case of an index, with the seed and kind of the options
static fuzzCase caseOf(const argList& args, const label index)
{
    const string kind(args.lookupOrDefault<string>("kind", ""));

    fuzzCase one;
    one.seed = args.lookupOrDefault<label>("seed", 1);
    one.index = index;
    one.hasNeedles = args.found("needles");
    one.isRemeshed = args.found("remesh");
    one.hasPolygons = args.found("polygons");
    one.isPeriodic = args.found("cyclic");
    one.isAtSides = one.isPeriodic || args.found("sides");
    one.hasSheets = args.found("sheets");
    one.hasRegions = one.hasSheets || args.found("regions");
    one.hasFarField =
        args.found("farField")
     || (one.hasPolygons && !one.isAtSides && !one.hasRegions);
    one.isAssembly = args.found("assemblies");
    if (one.isAssembly)
    {
        one.repair = surfaceRepairControls::method::stitch;
    }
    if (args.found("repair"))
    {
        one.repair =
            args["repair"] == "stitch"
          ? surfaceRepairControls::method::stitch
          : surfaceRepairControls::method::wrap;
    }
    one.kind =
        kind.size()
      ? randomSurfaces::kindOf(kind)
      : randomSurfaces::kind
        (
            index
          % (
                one.isAtSides
              ? label(randomSurfaces::kind::cutBody) : randomSurfaces::nKinds
            )
        );

    return one;
}


//- Returns whether all is well
static bool runCases(const argList& args, const fileName& folder)
{
    const clockTime time;
    const scalar seconds = args.lookupOrDefault<scalar>("seconds", 0);
    const label count = args.lookupOrDefault<label>("count", 150);

    fuzzTally counts;
    auto goesOn = [&]()
    {
        return
            seconds > 0
          ? time.elapsedTime() < seconds
          : counts.nRun() < count;
    };

    for (label index = 0; goesOn(); ++index)
    {
        const fuzzCase one(caseOf(args, index));
        const fuzzResult result(run(one, cpuSeconds));
        counts.add(one, result);
        report(one, result, folder);
    }

    counts.write(time.elapsedTime());

    return !counts.nFailed();
}


int main(int argc, char *argv[])
{
    addOptions();
    const argList args(argc, argv);
    const fileName folder(args.lookupOrDefault<fileName>("folder", ""));
    bool ok = true;

    if (args.found("index"))
    {
        const fuzzCase one(caseOf(args, args.get<label>("index")));
        write(one, folder);
        ok = runHere(one).what != fuzzResult::verdict::failed;
    }
    else
    {
        ok = runCases(args, folder);
    }

    // What main returns is lost: the destructor of args exits with 0
    if (!ok)
    {
        UPstream::exit(1);
    }

    return 0;
}


// ************************************************************************* //
