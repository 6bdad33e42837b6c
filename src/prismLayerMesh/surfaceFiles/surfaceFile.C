/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceFile.H"
#include "cadSurface.H"
#include "guardedReading.H"
#include "IFstream.H"
#include "MeshedSurfaces.H"
#include "OSspecific.H"
#include "surfaceFormats.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
        failToRead
        (
            file, "OpenFOAM would read the file " + plain + " instead"
        );
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
        valid << flatOutput(meshedSurface::readTypes().sortedToc());
        failToRead
        (
            file,
            "unknown extension '" + extension + "', valid: " + valid.str()
          + ", and CAD: step, stp, brep, iges, igs"
        );
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
