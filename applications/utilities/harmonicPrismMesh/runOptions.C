/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runOptions.H"
#include "argList.H"
#include "parallelRun.H"
#include "returnMemory.H"

#include <new>

namespace Foam
{

void addOptions()
{
    argList::noCheckProcessorDirectories();
    argList::addNote
    (
        "Make n layers of prisms on all of a wall surface, and on request the"
        " rest of the mesh.\n"
        "Reads system/harmonicPrismMeshDict and its surface. Writes\n"
        "  constant/polyMesh\n"
        "  constant/triSurface/layerOuter.obj, and sides.obj if the wall ends\n"
        "  postProcessing/harmonicPrismMesh/report, and report.json\n"
        "or refused.json there, with the exit status 1, 2 (dictionary), 3"
        " (surface),\n"
        "4 (no room for layers), 5 (memory, files) or 6 (a fault of this"
        " program).\n"
        "etc/caseDicts/annotated/harmonicPrismMeshDict describes every entry."
    );
    argList::addOption
    (
        "dict", "file", "Alternative to system/harmonicPrismMeshDict"
    );
    argList::addOption("region", "name", "Write the mesh of that region");
    argList::addBoolOption("overwrite", "Replace an existing mesh");
    argList::addBoolOption
    (
        "checkSurface", "Name the defects of the surface, write nothing"
    );
    argList::addBoolOption
    (
        "prepareSurface",
        "Repair and remesh the surface, write <name>.prepared.obj, no mesh"
    );
    argList::addBoolOption
    (
        "plan", "Say what cells, memory and time to expect, write nothing"
    );
    argList::addBoolOption
    (
        "splitRegions", "Write each region of the dictionary as a mesh of its"
        " own"
    );
    argList::addBoolOption("version", "Print the version, do nothing else");
    argList::addBoolOption
    (
        "writeFields",
        "Write VTK files of each stage, and a script that shows them in"
        " ParaView. Not with -parallel"
    );
}


void prepareRun()
{
    std::set_new_handler(nullptr);
    keepLongListsApart();

    const unsigned digits = 6;
    IOstream::defaultPrecision(digits);
    Sout.precision(digits);
    FatalError().precision(digits);
    FatalIOError.error::operator()().precision(digits);
}


void requireOneProcess(const argList& args, const parallelRun& parallel)
{
    for
    (
        const char* option
      : {"checkSurface", "prepareSurface", "plan", "writeFields"}
    )
    {
        if (parallel.isParallel() && args.found(option))
        {
            FatalErrorInFunction
                << "-checkSurface, -prepareSurface, -plan and -writeFields run"
                << " without -parallel"
                << exit(FatalError);
        }
    }
}


void refuseOptionsOfOne(const argList& args)
{
    for
    (
        const char* option
      : {
            "checkSurface", "prepareSurface", "plan", "writeFields", "region",
            "parallel"
        }
    )
    {
        if (args.found(option))
        {
            FatalErrorInFunction
                << "-" << option << " is not possible with regions" << nl
                << "Run without it" << exit(FatalError);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
