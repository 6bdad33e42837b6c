/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceFile.H"
#include "IFstream.H"
#include "MeshedSurfaces.H"
#include "OSspecific.H"
#include "surfaceFormats.H"
#include "throwingErrors.H"

#include <cfenv>
#include <new>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallSurface readSurfaceFile(const fileName& file, bool& separateFaces)
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
                readMeshedSurface(plain, extension, wall);
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

} // End namespace Foam

// ************************************************************************* //
