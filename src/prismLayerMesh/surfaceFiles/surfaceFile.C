/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceFile.H"
#include "cadSurface.H"
#include "IFstream.H"
#include "isolatedProcess.H"
#include "MeshedSurfaces.H"
#include "OSspecific.H"
#include "ranges.H"
#include "STLReader.H"
#include "throwingErrors.H"

#include <algorithm>
#include <cstring>

namespace Foam
{

namespace
{

//- What a file looks like from afar
struct fileProbe
{
    //- Size of the content [bytes]
    std::streamsize size = 0;

    //- Number of characters before the first that is not a 7-bit character
    std::streamsize asciiSize = 0;

    char header[84];
};

} // End anonymous namespace


static fileProbe probe(const fileName& file)
{
    IFstream is(file);
    std::istream& stream = is.stdStream();
    char buffer[1 << 14];
    fileProbe result;
    std::memset(result.header, 0, sizeof(result.header));

    while (stream)
    {
        stream.read(buffer, sizeof(buffer));
        const std::streamsize n = stream.gcount();

        if (result.size == 0)
        {
            std::memcpy
            (
                result.header,
                buffer,
                min(std::streamsize(sizeof(result.header)), n)
            );
        }

        if (result.asciiSize == result.size)
        {
            result.asciiSize += std::find_if
            (
                buffer,
                buffer + n,
                [](const char c) { return c <= 0; }
            ) - buffer;
        }

        result.size += n;
    }

    return result;
}


//- The reader goes by the first word, which lies in some binary files, takes
//  a truncated file for a whole one, and crashes on characters of 8 bits
static fileFormats::STLCore::STLFormat findFormat(const fileName& file)
{
    const fileProbe content(probe(file));
    uint32_t nFacets = 0;
    std::memcpy(&nFacets, content.header + 80, 4);
    const std::streamsize expected = 84 + 50*std::streamsize(nFacets);

    if (content.size >= 84 && content.size == expected)
    {
        return fileFormats::STLCore::BINARY;
    }

    const std::string text(content.header, 80);
    const auto start = text.find_first_not_of(" \t\r\n");
    const std::string first
    (
        start == std::string::npos ? "" : text.substr(start, 5)
    );

    if
    (
        (first == "solid" || first == "SOLID")
     && content.asciiSize == content.size
    )
    {
        return fileFormats::STLCore::ASCII;
    }

    FatalErrorInFunction
        << "it is neither an ascii STL nor a binary STL. An ascii STL begins"
        << " with 'solid' and has only ascii characters, here the first "
        << int64_t(content.asciiSize) << ". A binary STL with this number of"
        << " facets has " << int64_t(expected) << " bytes, here "
        << int64_t(content.size) << ". Is it truncated?" << exit(FatalError);

    return fileFormats::STLCore::UNKNOWN;
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
    const auto read = [&](pipeWriter&)
    {
        try
        {
            meshedSurface::New(file, extension);
        }
        catch (const std::exception&)
        {}
    };

    const auto nothing = [](pipeReader&) {};

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


//- Reads a wall with three points for each facet; patches have the names of the
//  solids. Errors: FatalError; the message does not name the file.
static void readStlSurface(const fileName& file, wallSurface& wall)
{
    fileFormats::STLReader reader(file, findFormat(file));

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


//- Reads a wall of any other format that OpenFOAM can read, by extension.
//  Errors: FatalError; the message does not name the file
static void readMeshedSurface
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

    const autoPtr<meshedSurface> surface(meshedSurface::New(file, extension));

    wall.points = surface().points();
    wall.faces = surface().surfFaces();
    setPatches(surface().surfZones(), wall);
}


// * * * * * * * * * * * * * * *  Surface File * * * * * * * * * * * * * * * //

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
        failToRead(file, "OpenFOAM would read the file " + plain + " instead");
    }

    return plain;
}


static void checkLabels(const fileName& file, const wallSurface& wall)
{
    forAll(wall.faces, facei)
    {
        for (const label p : wall.faces[facei])
        {
            if (p < 0 || p >= wall.points.size())
            {
                failToRead
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


static void checkExtension(const fileName& file, const fileName& plain)
{
    const word extension(plain.ext());

    if (cadType(plain).size())
    {
        failToRead
        (
            file,
            file != plain ? "CAD is not read compressed"
          : "it is CAD: the labels of its triangles are unknown before gmsh"
            " makes them. Use " + plain.nameLessExt() + ".prepared.obj"
        );
    }

    if (!meshedSurface::canReadType(extension))
    {
        OStringStream valid;
        valid << listed(meshedSurface::readTypes().sortedToc()).c_str();
        failToRead
        (
            file,
            "unknown extension '" + extension + "', valid: " + valid.str()
          + ", and CAD: step, stp, brep, iges, igs"
        );
    }
}


wallSurface readSurfaceFile(const fileName& file, bool& separateFaces)
{
    const fileName plain(uncompressedName(file));
    const word extension(plain.ext());

    if (!isFile(plain, true))
    {
        failToRead(file, "there is no such file");
    }

    checkExtension(file, plain);

    if (IFstream(plain).stdStream().peek() == std::istream::traits_type::eof())
    {
        failToRead(file, "the file is empty");
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
                readMeshedSurface(plain, extension, wall);
            }
        }
    );

    if (wall.faces.empty())
    {
        failToRead(file, "there are no faces in it");
    }

    checkLabels(file, wall);

    return wall;
}

} // End namespace Foam

// ************************************************************************* //
