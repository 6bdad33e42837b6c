/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "surfaceFile.H"
#include "IFstream.H"
#include "isolatedProcess.H"
#include "MeshedSurfaces.H"
#include "OSspecific.H"
#include "stlSurface.H"
#include "throwingErrors.H"

#include <cstring>
#include <cfenv>
#include <new>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

[[noreturn]] static void fail(const fileName& file, const string& what)
{
    FatalErrorInFunction
        << "Cannot read the surface " << file << ": " << what.c_str()
        << exit(FatalError);

    std::abort();
}


namespace
{

//- As long as it lives, fatal errors and a lack of memory throw exceptions,
//  and readers print nothing
class quietReading
{
    const throwingErrors throwing_ = throwingErrors(true);
    const int level_ = messageStream::level;
    const std::new_handler newHandler_ = std::set_new_handler(nullptr);
    std::fenv_t environment_;

public:

    quietReading()
    {
        messageStream::level = 0;

        // A comparison with NaN must not end the process
        std::feholdexcept(&environment_);
    }

    ~quietReading()
    {
        std::fesetenv(&environment_);
        std::set_new_handler(newHandler_);
        messageStream::level = level_;
    }
};

} // End anonymous namespace


//- Run a reader, whose errors do not always name the file
template<class Reader>
static void readGuarded(const fileName& file, const Reader& read)
{
    string what;

    try
    {
        const quietReading guard;
        read();
    }
    catch (const Foam::error& e)
    {
        what = e.message();
    }
    catch (const std::bad_alloc&)
    {
        what = "its sizes are beyond the memory; is it broken?";
    }
    catch (const std::exception& e)
    {
        what = e.what();
    }

    if (what.size())
    {
        fail(file, what);
    }
}


//- The name without .gz, which OpenFOAM's streams add
static fileName uncompressedName(const fileName& file)
{
    if (file.ext() != "gz")
    {
        return file;
    }

    const fileName plain(file.lessExt());

    if (isFile(plain, false))
    {
        fail(file, "the file " + plain + " beside it would be read instead");
    }

    return plain;
}


//- OpenFOAM's reader takes three coordinates without looking
static void checkObjPoints(const fileName& file)
{
    IFstream is(file);
    std::istream& stream = is.stdStream();
    std::string line;

    for (label lineNumber = 1; std::getline(stream, line); ++lineNumber)
    {
        const auto start = line.find_first_not_of(" \t\r");

        if
        (
            start == std::string::npos
         || line[start] != 'v'
         || !std::isspace(line[min(start + 1, line.size() - 1)])
        )
        {
            continue;
        }

        const char* c = line.c_str() + start + 1;
        label n = 0;

        while (n < 3 && *(c += std::strspn(c, " \t\r")))
        {
            c += std::strcspn(c, " \t\r");
            ++n;
        }

        if (n < 3)
        {
            FatalErrorInFunction
                << "the point on line " << lineNumber
                << " does not have three coordinates" << exit(FatalError);
        }
    }
}


//- The readers of formats that are not checked here are tried out first in a
//  process of their own, because some crash on inconsistent sizes
static void tryReader(const fileName& file, const word& extension)
{
    const auto read = [&](std::FILE*)
    {
        try
        {
            meshedSurface::New(file, extension);
        }
        catch (const std::exception&)
        {}
    };

    const auto nothing = [](std::FILE*) { return true; };

    if (isolatedProcess(read, nothing, 600) != processEnd::complete)
    {
        FatalErrorInFunction
            << "the reader crashes; is it broken?" << exit(FatalError);
    }
}


static void setPatches(const surfZoneList& zones, wallSurface& wall)
{
    const label nFaces = wall.faces.size();
    wall.patchIDs.setSize(nFaces);
    wall.patchIDs = 0;
    wall.patchNames = wordList(1, word("zone0"));

    // Some readers leave the sizes of zones at zero: then there are none
    label nInZones = 0;
    for (const surfZone& zone : zones)
    {
        nInZones += zone.size();
    }

    if (nInZones != nFaces)
    {
        return;
    }

    wall.patchNames.setSize(zones.size());

    forAll(zones, i)
    {
        wall.patchNames[i] = zones[i].name();

        for (label j = 0; j < zones[i].size(); ++j)
        {
            wall.patchIDs[zones[i].start() + j] = i;
        }
    }
}


static void readMeshed
(
    const fileName& file,
    const word& extension,
    wallSurface& wall
)
{
    if (extension == "obj")
    {
        checkObjPoints(file);
    }
    else if (extension != "off")
    {
        tryReader(file, extension);
    }

    const autoPtr<meshedSurface> surface
    (
        meshedSurface::New(file, extension)
    );

    wall.points = surface().points();
    wall.faces = surface().surfFaces();
    setPatches(surface().surfZones(), wall);
}


static void checkLabels(const fileName& file, const wallSurface& wall)
{
    forAll(wall.faces, facei)
    {
        for (const label p : wall.faces[facei])
        {
            if (p < 0 || p >= wall.points.size())
            {
                fail
                (
                    file,
                    "face " + Foam::name(facei) + " refers to point "
                  + Foam::name(p) + " of " + Foam::name(wall.points.size())
                  + ", counted from 0 (relative indices are not read)"
                );
            }
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::readSurfaceFile
(
    const fileName& file,
    bool& separateFaces
)
{
    const fileName plain(uncompressedName(file));
    const word extension(plain.ext());

    if (!isFile(plain, true))
    {
        fail(file, "there is no such file");
    }

    if (!meshedSurface::canReadType(extension))
    {
        OStringStream valid;
        valid << flatOutput(meshedSurface::readTypes().sortedToc());
        fail
        (
            file,
            "unknown extension '" + extension + "', valid: " + valid.str()
        );
    }

    if (IFstream(plain).stdStream().peek() == std::istream::traits_type::eof())
    {
        fail(file, "the file is empty");
    }

    separateFaces = (extension == "stl" || extension == "stlb");
    wallSurface wall;

    readGuarded
    (
        file,
        [&]()
        {
            if (separateFaces)
            {
                readStlSurface(plain, wall);
            }
            else
            {
                readMeshed(plain, extension, wall);
            }
        }
    );

    if (wall.faces.empty())
    {
        fail(file, "there are no faces in it");
    }

    checkLabels(file, wall);

    return wall;
}


// ************************************************************************* //
