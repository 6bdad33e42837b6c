/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    harmonicPrismExport

Group
    grpMeshConversionUtilities

Description
    Writes a mesh for other programs: SU2 (.su2), Gmsh (.msh), CGNS (.cgns) or
    VTK (.vtu).

    Cells that are no tetrahedron, pyramid, prism or hexahedron are divided into
    pyramids and tetrahedra. All elements are positive, by exact predicates, and
    conformal. Patches and cellZones keep their names. A mesh of one cell
    between patches of type empty is written as its plane.

Usage
    \b harmonicPrismExport [OPTIONS] \<file\>

    Options:
      - \par -mshVersion \<4.1|2.2\>
        Version of a file .msh; default 4.1

      - \par -overwrite
        Replace a file that is there already

      - \par -region \<name\>
        Write the mesh of that region

      - \par -version
        Print the version, and do nothing else

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "OSspecific.H"
#include "pluginVersion.H"
#include "polyMesh.H"
#include "SubField.H"
#include "Time.H"
#include "writeCgns.H"
#include "writeElements.H"

#include <fstream>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

static void addOptions()
{
    argList::noParallel();
    argList::addNote
    (
        "Write a mesh for other programs: SU2, Gmsh, CGNS, VTK.\n"
        "Polyhedra are divided into pyramids and tetrahedra; patches and"
        " cellZones keep their names."
    );
    argList::addArgument
    (
        "file", "The file to write: .su2, .msh, .cgns or .vtu"
    );
    argList::addOption
    (
        "mshVersion", "4.1|2.2", "Version of a file .msh. Default: 4.1"
    );
    argList::addBoolOption("overwrite", "Replace an existing file");
    argList::addOption("region", "name", "Write the mesh of that region");
    argList::addBoolOption("version", "Print the version, do nothing else");
}


//- The format: su2, msh4.1, msh2.2, cgns or vtu
static word formatOf(const argList& args, const fileName& file)
{
    const word extension(file.ext());
    if (!wordList({"su2", "msh", "cgns", "vtu"}).found(extension))
    {
        FatalErrorInFunction
            << "The format of " << file << " is not known: names end with .su2,"
            << " .msh, .cgns or .vtu" << exit(FatalError);
    }
    const word version(args.lookupOrDefault<word>("mshVersion", "4.1"));
    if (version != "4.1" && version != "2.2")
    {
        FatalErrorInFunction
            << "-mshVersion is 4.1 or 2.2, not " << version << exit(FatalError);
    }

    return extension == "msh" ? word(extension + version) : extension;
}


static void checkFile(const argList& args, const fileName& file)
{
    if (exists(file) && !args.found("overwrite"))
    {
        FatalErrorInFunction
            << file << " is there already: -overwrite replaces it"
            << exit(FatalError);
    }
}


//- Warns of names with characters that mean something else in the configuration
//  of SU2
static void warnOfMarkers(const elementMesh& mesh)
{
    for (const elementGroup& patch : mesh.patches)
    {
        if (patch.name.find_first_of("%,()=") != word::npos)
        {
            WarningInFunction
                << "The configuration of SU2 cannot name the marker "
                << patch.name << ": rename the patch" << endl;
        }
    }
}


//- Writes the file under another name, and renames it if it is complete
static void write
(
    const elementMesh& mesh,
    const word& format,
    const fileName& file
)
{
    const fileName part(file + ".part");
    rm(part);

    if (format == "cgns")
    {
        writeCgns(mesh, part);
    }
    else
    {
        std::ofstream os(part, std::ios::binary);
        if (format == "su2")
        {
            warnOfMarkers(mesh);
            writeSu2(mesh, os);
        }
        else if (format == "vtu")
        {
            writeVtu(mesh, os);
        }
        else
        {
            (format == "msh2.2" ? writeMsh2 : writeMsh4)(mesh, os);
        }
        os.close();
        if (!os)
        {
            rm(part);
            FatalErrorInFunction
                << "Cannot write " << file << exit(FatalError);
        }
    }
    mv(part, file);
}


static void writeShapes(const elementMesh& elements, const label nCells)
{
    Info<< nl << "Cells: " << nCells << ", divided " << elements.nDivided << nl
        << nl << "Elements" << nl;
    for (label i = 0; i < nElementShapes; ++i)
    {
        if (const label n = elements.count(elementShape(i)))
        {
            Info<< "    " << factsOf(elementShape(i)).name << ' ' << n << nl;
        }
    }
}


//- Logs volumes, or areas in a plane; in three dimensions beside the volume of
//  the mesh
static void writeZones(const elementMesh& elements, const polyMesh& mesh)
{
    const bool solid = elements.dimension == 3;
    scalar all = 0;

    Info<< nl << "Zones: elements, " << (solid ? "volume [m3]" : "area [m2]")
        << nl;
    for (const elementGroup& zone : elements.zones)
    {
        const scalar volume = elements.volume(zone);
        all += volume;
        Info<< "    " << zone.name.c_str() << ' ' << zone.size << ' ' << volume
            << nl;
    }
    Info<< "    all " << elements.cells.size() << ' ' << all;
    if (solid)
    {
        Info<< ", of the mesh " << sum(mesh.cellVolumes());
    }
    Info<< nl;
}


//- Logs the areas of patches and the areas in the mesh; in a plane, lengths
static void writePatches(const elementMesh& elements, const polyMesh& mesh)
{
    const bool solid = elements.dimension == 3;

    Info<< nl << "Patches: elements, " << (solid ? "area [m2]" : "length [m]")
        << nl;
    for (const elementGroup& patch : elements.patches)
    {
        Info<< "    " << patch.name.c_str() << ' ' << patch.size << ' '
            << elements.area(patch);
        if (solid)
        {
            const polyPatch& given = mesh.boundaryMesh()[patch.name];
            Info<< ", of the mesh " << sum(mag(given.faceAreas()));
        }
        Info<< nl;
    }
    Info<< nl;
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

    const fileName file(args[1]);
    const word format(formatOf(args, file));
    checkFile(args, file);

    const polyMesh mesh
    (
        IOobject
        (
            args.lookupOrDefault<word>("region", polyMesh::defaultRegion),
            runTime.timeName(), runTime, IOobject::MUST_READ
        )
    );
    const elementMesh elements(elementsOf(mesh));
    write(elements, format, file);

    OSstream& log = Info;
    log.precision(12);
    writeShapes(elements, mesh.nCells());
    writeZones(elements, mesh);
    writePatches(elements, mesh);
    Info<< "Wrote " << file << nl << endl;

    return 0;
}


// ************************************************************************* //
