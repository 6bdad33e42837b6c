/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    snappyToPrism

Group
    grpMeshGenerationUtilities

Description
    Makes a dictionary of harmonicPrismMesh for a case of snappyHexMesh.

    Reads system/snappyHexMeshDict, system/blockMeshDict and the surface files
    in constant/triSurface. Writes system/harmonicPrismMeshDict. Comments at its
    end name what has no counterpart.

Usage
    \b snappyToPrism [OPTIONS]

    Options:
      - \par -repair \<none|stitch|wrap\>
        Repair of the surface; default stitch if the surface goes through a side
        of the box, otherwise none

      - \par -overwrite
        Replace a dictionary that is there already

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "IOdictionary.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "pluginVersion.H"
#include "prismEntries.H"
#include "readPrismLayerControls.H"
#include "readRegionControls.H"
#include "StringStream.H"
#include "throwingErrors.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

static void addOptions()
{
    argList::noParallel();
    argList::addNote
    (
        "Make system/harmonicPrismMeshDict for a case of snappyHexMesh.\n"
        "Reads system/snappyHexMeshDict, system/blockMeshDict and the surface"
        " files.\nComments in the dictionary name what has no counterpart."
    );
    argList::addOption
    (
        "repair", "method",
        "Repair of the surface: none, stitch or wrap. Default: stitch if the"
        " surface goes through a side of the box"
    );
    argList::addBoolOption("overwrite", "Replace an existing dictionary");
}


//- Checks entries as harmonicPrismMesh does.
//  Errors: FatalError with the entry that is out of bounds
static void checkEntries(const dictionary& entries)
{
    try
    {
        const throwingErrors guard(true);
        if (entries.found("regions"))
        {
            const auto sides = [](const farBoundaryControls&)
            {
                return farBoundary();
            };
            readRegionControls(entries, sides);
        }
        else
        {
            readPrismLayerControls(entries);
        }
    }
    catch (const Foam::error& e)
    {
        FatalErrorInFunction
            << "snappyHexMeshDict leads to an entry that harmonicPrismMesh"
            << " refuses:" << nl << e.message().c_str() << nl
            << "Change the entry of snappyHexMeshDict that it comes from, see"
            << " doc/fromSnappyHexMesh.md" << exit(FatalError);
    }
}


//- Returns entries as they will be written, after a check.
static string readableText(const dictionary& entries)
{
    OStringStream os;
    os.precision(10);
    for (const entry& e : entries)
    {
        os << e << nl;
    }
    IStringStream is(os.str());
    checkEntries(dictionary(is));

    return os.str();
}


static void writeDict
(
    const fileName& file,
    const string& entries,
    const remarkList& remarks
)
{
    OFstream os(file);
    IOobject::writeBanner(os)
        << "FoamFile" << nl << '{' << nl
        << "    version     2.0;" << nl << "    format      ascii;" << nl
        << "    class       dictionary;" << nl
        << "    object      harmonicPrismMeshDict;" << nl << '}' << nl;
    IOobject::writeDivider(os) << nl;
    os << entries.c_str()
        << "// What was not converted: see doc/fromSnappyHexMesh.md" << nl;
    for (const string& remark : remarks)
    {
        os << "// - " << remark.c_str() << nl;
    }
    IOobject::writeEndDivider(os);
}


//- The method of repair that the option asks for
static word repairOf(const argList& args)
{
    const word repair(args.getOrDefault<word>("repair", ""));
    if (repair.size() && !wordList({"none", "stitch", "wrap"}).found(repair))
    {
        FatalErrorInFunction
            << "-repair is none, stitch or wrap, not " << repair
            << exit(FatalError);
    }

    return repair;
}


int main(int argc, char *argv[])
{
    if (versionIsAsked(argc, argv))
    {
        return 0;
    }

    addOptions();

    #include "setRootCase.H"
    #include "createTime.H"

    const fileName file(runTime.system()/"harmonicPrismMeshDict");
    if (isFile(file) && !args.found("overwrite"))
    {
        FatalErrorInFunction
            << file << " is there already: -overwrite replaces it"
            << exit(FatalError);
    }
    const IOdictionary dict
    (
        IOobject
        (
            "snappyHexMeshDict", runTime.system(), runTime, IOobject::MUST_READ,
            IOobject::NO_WRITE, false
        )
    );
    remarkList remarks;
    snappyCase given;
    given.repair = repairOf(args);
    given.snappy = dict;
    given.box = readBlockBox(runTime, remarks);
    given.walls = readSnappyWalls(dict, runTime, remarks);
    const string entries(readableText(prismEntries(given, remarks)));
    writeDict(file, entries, remarks);

    Info<< nl << "Surfaces: " << flatOutput(given.walls.files) << nl
        << "Comments: " << remarks.size() << nl << "Dictionary: " << file << nl
        << "Next: "
        << (given.hasBaffles() ? "" : "harmonicPrismMesh -checkSurface, then ")
        << "harmonicPrismMesh" << nl
        << nl << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
