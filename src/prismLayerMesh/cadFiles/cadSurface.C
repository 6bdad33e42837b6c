/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadSurface.H"
#include "cadTriangulation.H"
#include "clockTime.H"
#include "gmshOutput.H"
#include "isolatedProcess.H"
#include "OSspecific.H"
#include "stepFaceNames.H"
#include "stringOps.H"
#include "throwingErrors.H"

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Algorithms of gmsh on surfaces, in the order in which they are tried:
//  frontal Delaunay, MeshAdapt, Delaunay
static const labelList algorithms({6, 1, 5});


static string logOf(const fileName& folder, string (*read)(std::istream&))
{
    std::ifstream log(folder/"log");

    return read(log);
}


//- Runs gmsh.
//  Errors: FatalError if there is no gmsh
static programEnd runGmsh
(
    const fileName& folder,
    const std::string& script,
    const scalar seconds
)
{
    for (const char* old : {"model", "body.msh"})
    {
        std::remove((folder/old).c_str());
    }
    std::ofstream(folder/"body.geo") << script;

    const programEnd end = runProgram
    (
        {"gmsh", "-2", "-o", "body.msh", "body.geo"},
        // Where the settings of the user are not
        {"GMSH_HOME=" + folder},
        folder,
        "log",
        seconds
    );

    if (end == programEnd::missing)
    {
        FatalErrorInFunction
            << "it is CAD. Install the program gmsh (Debian: apt-get install"
            << " gmsh), or export triangles" << exit(FatalError);
    }

    return end;
}


[[noreturn]] static void failWithoutTriangles
(
    const programEnd end,
    const bool hasFaces,
    const label maxSeconds,
    const string& errors
)
{
    if (end == programEnd::tooLong)
    {
        FatalErrorInFunction
            << "the program gmsh takes longer than " << maxSeconds
            << " s. Give it more time, surface.cad.maxSeconds, or ask for fewer"
            << " triangles: surface.cad.maxEdge, surface.cad.nPerCircle"
            << exit(FatalError);
    }

    FatalErrorInFunction
        << "the program gmsh "
        << (hasFaces ? "makes no triangles of it" : "finds no faces in it")
        << (errors.empty() ? "" : ": ") << errors.c_str() << exit(FatalError);

    std::abort();
}


namespace
{

//- What is tried on a file, and the best triangles so far
struct attempts
{
    const fileName folder;
    const word name;
    const surfaceCadControls& controls;
    const scalar maxEdge;

    //- What readStepFaceNames returns; empty for other files
    const List<stringList> faceNames;
    const clockTime timer = clockTime();

    cadTriangulation best = cadTriangulation();

    //- Version and algorithm of gmsh that made them
    string by = string();

    //- How the last attempt ended
    programEnd end = programEnd::failed;
    bool hasFaces = true;
    string errors = string();

    bool haveTriangles() const { return best.wall.faces.size(); }

    //- Whether more attempts are of no use
    bool areOver() const
    {
        return end == programEnd::tooLong
         || (haveTriangles() && best.nFaults() == 0);
    }

    void add(bool unite, label algorithm);
};


void attempts::add(const bool unite, const label algorithm)
{
    const std::string script
    (
        gmshScript
        (
            name, "model", unite, maxEdge, controls.nPerCircle, algorithm
        )
    );
    end = runGmsh(folder, script, controls.maxSeconds - timer.elapsedTime());

    std::ifstream model(folder/"model"), mesh(folder/"body.msh");
    cadModel found(readCadModel(model));
    // Uniting solids divides their faces
    if (!unite || found.solidLabels.size() < 2)
    {
        nameFaces(faceNames, found);
    }
    hasFaces = found.faces.size();
    errors = logOf(folder, errorsIn);

    if (end != programEnd::complete || !hasFaces)
    {
        return;
    }

    cadTriangulation made(makeCadTriangulation(found, readMsh(mesh)));

    if (!haveTriangles() || made.nFaults() < best.nFaults())
    {
        best = std::move(made);
        by = logOf(folder, versionIn) + ", algorithm " + Foam::name(algorithm)
          + (unite && found.solidLabels.size() > 1 ? ", solids united" : "");
    }
}

} // End anonymous namespace


//- Tries algorithms until the triangles are good.
//  Errors: FatalError if there are none
static void triangulate(const bool unite, attempts& tried)
{
    for (const bool united : {true, false})
    {
        if (united && !unite)
        {
            continue;
        }

        for (const label algorithm : algorithms)
        {
            tried.add(united, algorithm);

            if (tried.areOver() || !tried.hasFaces)
            {
                break;
            }
        }

        if (tried.areOver() || tried.haveTriangles())
        {
            break;
        }
    }

    if (!tried.haveTriangles())
    {
        failWithoutTriangles
        (
            tried.end, tried.hasFaces, tried.controls.maxSeconds, tried.errors
        );
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

word cadType(const fileName& file)
{
    const word extension(stringOps::lower(file.ext()));

    return
        extension == "step" || extension == "stp" ? "step"
      : extension == "iges" || extension == "igs" ? "iges"
      : extension == "brep" ? "brep"
      : "";
}


wallSurface readCadSurface
(
    const fileName& file,
    const surfaceCadControls& controls,
    const bool unite,
    const scalar scale,
    string& remark
)
{
    wallSurface wall;
    const word type(cadType(file));

    if (!isFile(file, false))
    {
        failToRead(file, "there is no such file");
    }

    readGuarded
    (
        file,
        [&]()
        {
            const scratchFolder folder;
            const word name("body." + type);
            std::ofstream(folder.path()/name, std::ios::binary)
                << std::ifstream(file, std::ios::binary).rdbuf();
            std::ifstream text(file, std::ios::binary), step(file);

            attempts tried
            {
                folder.path(), name, controls, controls.maxEdge/scale,
                type == "step" ? readStepFaceNames(step) : List<stringList>()
            };
            triangulate(unite, tried);
            const word unit(cadUnit(text, type));
            remark = describe(tried.best, unit, scale, tried.by);
            wall = std::move(tried.best.wall);
        }
    );

    return wall;
}

} // End namespace Foam

// ************************************************************************* //
