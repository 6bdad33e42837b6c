/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    makeTestSurface

Description
    Writes one of the shapes of the unit tests to a file, for the case tests.

Usage
    \b makeTestSurface \<file\> \<shape\> [number...]

    The format is that of the file's extension. Called without arguments it
    lists the shapes and the numbers that they take.

\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "MeshedSurface.H"

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef std::vector<scalar> numbers;

struct shape
{
    std::string name;
    std::string arguments;
    size_t nArguments;
    std::function<wallSurface(const numbers&)> make;
};


//- Spheres of radius 1
static wallSurface twoBodies(const label n, const scalar gap)
{
    const wallSurface one(testSurfaces::sphere(n));

    return testSurfaces::merge
    (
        one, testSurfaces::translated(one, vector(2 + gap, 0, 0))
    );
}


//- The quadCube with each second square cut into triangles
static wallSurface mixed(const label n)
{
    wallSurface wall(testSurfaces::quadCube(n));
    DynamicList<face> faces;

    forAll(wall.faces, i)
    {
        const face& f = wall.faces[i];

        if (i % 2)
        {
            faces.append(f);
            continue;
        }

        for (label j = 0; j < 2; ++j)
        {
            face t(3);
            t[0] = f[2*j];
            t[1] = f[2*j + 1];
            t[2] = f[(2*j + 2) % 4];
            faces.append(t);
        }
    }

    wall.faces.transfer(faces);
    wall.patchIDs.setSize(wall.faces.size());
    wall.patchIDs = 0;

    return wall;
}


//- The cube with a patch for each pair of opposite sides
static wallSurface threePatches(const label n)
{
    wallSurface wall(testSurfaces::cube(n));
    const vectorField normals(wall.faceNormals());
    wall.patchNames = wordList({"xSides", "ySides", "zSides"});

    forAll(normals, i)
    {
        for (direction d = 1; d < 3; ++d)
        {
            if (mag(normals[i][d]) > 0.5)
            {
                wall.patchIDs[i] = d;
            }
        }
    }

    return wall;
}


static std::vector<shape> shapes()
{
    using namespace testSurfaces;

    return
    {
        {
            "cube", "n size", 2,
            [](const numbers& x) { return cube(x[0], x[1]); }
        },
        {
            "quadCube", "n size", 2,
            [](const numbers& x) { return quadCube(x[0], x[1]); }
        },
        {
            "sphere", "n radius", 2,
            [](const numbers& x) { return sphere(x[0], x[1]); }
        },
        {
            "quadSphere", "n radius", 2,
            [](const numbers& x) { return quadSphere(x[0], x[1]); }
        },
        {
            "torus", "nMajor nMinor R r", 4,
            [](const numbers& x) { return torus(x[0], x[1], x[2], x[3]); }
        },
        {
            "lBlock", "n", 1,
            [](const numbers& x) { return lBlock(x[0]); }
        },
        {
            "wedgeBlock", "n angle", 2,
            [](const numbers& x) { return wedgeBlock(x[0], x[1]); }
        },
        {
            "slitBlock", "n width", 2,
            [](const numbers& x) { return slitBlock(x[0], x[1]); }
        },
        {
            "twoBodies", "n gap", 2,
            [](const numbers& x) { return ::twoBodies(x[0], x[1]); }
        },
        {
            "mixed", "n", 1,
            [](const numbers& x) { return ::mixed(x[0]); }
        },
        {
            "threePatches", "n", 1,
            [](const numbers& x) { return ::threePatches(x[0]); }
        }
    };
}


static int usage()
{
    std::cerr << "Usage: makeTestSurface <file> <shape> [number...]\n";

    for (const shape& s : shapes())
    {
        std::cerr << "    " << s.name << ' ' << s.arguments << '\n';
    }

    return 1;
}


//- Write, patches as zones
static void write(const wallSurface& wall, const fileName& file)
{
    DynamicList<face> faces;
    List<surfZone> zones(wall.patchNames.size());

    forAll(zones, patchi)
    {
        const label start = faces.size();

        forAll(wall.faces, i)
        {
            if (wall.patchIDs[i] == patchi)
            {
                faces.append(wall.faces[i]);
            }
        }

        zones[patchi] = surfZone
        (
            wall.patchNames[patchi], faces.size() - start, start, patchi
        );
    }

    // Text of all formats is then the same surface
    IOstream::defaultPrecision(17);

    faceList sorted(std::move(faces));
    MeshedSurface<face>
    (
        pointField(wall.points), std::move(sorted), zones
    ).write(file);
}


int main(int argc, char *argv[])
{
    if (argc < 3)
    {
        return usage();
    }

    numbers arguments;
    for (int i = 3; i < argc; ++i)
    {
        arguments.push_back(std::atof(argv[i]));
    }

    for (const shape& s : shapes())
    {
        if (s.name == argv[2] && s.nArguments == arguments.size())
        {
            write(s.make(arguments), argv[1]);
            return 0;
        }
    }

    return usage();
}


// ************************************************************************* //
