/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "surfaceFile.H"
#include "IFstream.H"
#include "MeshedSurfaces.H"
#include "OSspecific.H"
#include "STLReader.H"

#include <cstring>

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


//- Fatal errors are exceptions as long as it lives
class errorsThrown
{
    const bool error_ = FatalError.throwExceptions(true);
    const bool ioError_ = FatalIOError.throwExceptions(true);

public:

    ~errorsThrown()
    {
        FatalError.throwExceptions(error_);
        FatalIOError.throwExceptions(ioError_);
    }
};


//- Run a reader; its errors do not always name the file
template<class Reader>
static void readGuarded(const fileName& file, const Reader& read)
{
    string what;

    try
    {
        const errorsThrown guard;
        read();
    }
    catch (const Foam::error& e)
    {
        what = e.message();
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


//- Size in bytes of the content, and its first 84
static std::streamsize probe(const fileName& file, char header[84])
{
    IFstream is(file);
    std::istream& stream = is.stdStream();
    char buffer[1 << 14];
    std::streamsize size = 0;
    std::memset(header, 0, 84);

    while (stream)
    {
        stream.read(buffer, sizeof(buffer));

        if (size == 0)
        {
            const std::streamsize n = min(std::streamsize(84), stream.gcount());
            std::memcpy(header, buffer, n);
        }

        size += stream.gcount();
    }

    return size;
}


//- The reader goes by the first word, which lies in some binary files, and
//  takes a truncated file for a whole one
static fileFormats::STLCore::STLFormat stlFormat(const fileName& file)
{
    char header[84];
    const std::streamsize size = probe(file, header);

    uint32_t nFacets = 0;
    std::memcpy(&nFacets, header + 80, 4);
    const std::streamsize expected = 84 + 50*std::streamsize(nFacets);

    if (size >= 84 && size == expected)
    {
        return fileFormats::STLCore::BINARY;
    }

    const string text(std::string(header, 80));
    const auto start = text.find_first_not_of(" \t\r\n");

    if
    (
        start != std::string::npos
     && (text.compare(start, 5, "solid") == 0
      || text.compare(start, 5, "SOLID") == 0)
    )
    {
        return fileFormats::STLCore::ASCII;
    }

    fail
    (
        file,
        "neither an ascii STL, which begins with 'solid', nor a binary STL,"
        " which would have " + Foam::name(int64_t(expected)) + " bytes and not "
      + Foam::name(int64_t(size)) + "; is it truncated?"
    );
}


static void readStl(const fileName& file, wallSurface& wall)
{
    fileFormats::STLReader reader(file, stlFormat(file));

    const auto& points = reader.points();
    wall.patchIDs = reader.zoneIds();
    wall.patchNames = reader.names();
    const label nFaces = wall.patchIDs.size();

    if (points.size() != 3*nFaces)
    {
        FatalErrorInFunction
            << "a facet does not have three points" << exit(FatalError);
    }

    wall.points.setSize(points.size());
    wall.faces.setSize(nFaces);

    forAll(wall.points, i)
    {
        wall.points[i] = point(points[i].x(), points[i].y(), points[i].z());
    }

    forAll(wall.faces, i)
    {
        wall.faces[i] = face(identity(3, 3*i));
    }

    // The solids of a binary file are numbers
    for (label i = wall.patchNames.size(); i < reader.sizes().size(); ++i)
    {
        wall.patchNames.append("zone" + Foam::name(i));
    }
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

    char header[84];
    if (probe(plain, header) == 0)
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
            separateFaces
          ? readStl(plain, wall)
          : readMeshed(plain, extension, wall);
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
