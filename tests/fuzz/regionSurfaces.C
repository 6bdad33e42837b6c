/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshRegions.H"
#include "mathematicalConstants.H"
#include "randomSurface.H"
#include "testSurfaces.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A cylinder with its axis along z, or a cube, in the cell about the origin.
//  It ends in the sides of the cell. A cube may have another body within it.
static wallSurface bodyInCell(Random& random)
{
    using constant::mathematical::twoPi;

    wallSurface body(testSurfaces::cube(random.position<label>(1, 3)));
    const bool isCube = randomSurfaces::chance(random, 0.5);
    if (!isCube)
    {
        const label n = random.position<label>(5, 16);
        const scalar radius = random.position<scalar>(0.2, 0.45);
        List<vector2D> circle(n);
        forAll(circle, i)
        {
            const scalar phi = twoPi*i/n;
            circle[i] = radius*vector2D(Foam::cos(phi), Foam::sin(phi))
              + 0.5*vector2D::one;
        }
        body = testSurfaces::extruded(circle, 1, 0.5);
    }
    else if (randomSurfaces::chance(random, 0.3))
    {
        const label n = random.position<label>(1, 3);
        wallSurface within(testSurfaces::sphere(2*n, 0.3));
        for (point& x : within.points)
        {
            x += 0.5*vector::one;
        }
        body = testSurfaces::merge(body, within);
    }
    for (point& x : body.points)
    {
        x -= 0.5*vector::one;
    }

    return body;
}


//- One to three bodies in a row, which meet in sides of their cells or leave a
//  gap
static wallSurface bodiesInRow(Random& random)
{
    const label n = random.position<label>(1, 3);
    const label direction = random.position<label>(0, 2);
    wallSurface row;
    scalar z = 0;
    for (label i = 0; i < n; ++i)
    {
        wallSurface body(bodyInCell(random));
        const scalar size = random.position<scalar>(0.5, 0.95);
        for (point& x : body.points)
        {
            x.x() *= size;
            x.y() *= size;
            x.z() += z;
            for (label k = 0; k < direction; ++k)
            {
                x = point(x.y(), x.z(), x.x());
            }
            x += direction == 0 ? vector(1, 1, 0)
              : direction == 1 ? vector(1, 0, 1) : vector(0, 1, 1);
        }
        row = i ? testSurfaces::merge(row, body) : body;
        z += randomSurfaces::chance(random, 0.7) ? 1 : 1.2;
    }

    return row;
}


//- A square about the origin, which may be bent, or a tube about the x axis
static wallSurface randomSheet(Random& random)
{
    using constant::mathematical::twoPi;

    const label n = random.position<label>(1, 5);
    wallSurface sheet;
    sheet.points.setSize((n + 1)*(n + 1));
    forAll(sheet.points, p)
    {
        sheet.points[p] =
            vector(p % (n + 1), p/(n + 1), 0)/n - vector(0.5, 0.5, 0);
    }
    for (label i = 0; i < n*n; ++i)
    {
        const label a = i % n + (n + 1)*(i/n);
        const label c = a + n + 2;
        sheet.faces.append(face({a, a + 1, c}));
        sheet.faces.append(face({a, c, a + n + 1}));
    }

    if (randomSurfaces::chance(random, 0.3))
    {
        // The tube is open along a line if it goes around by less than a turn
        const scalar turn = random.position<scalar>(0.2, 0.9)*twoPi;
        for (point& x : sheet.points)
        {
            const scalar phi = turn*x.y();
            const scalar r = 1/turn;
            x.y() = r*Foam::sin(phi);
            x.z() = r*(1 - Foam::cos(phi));
        }
    }
    for (label k = random.position<label>(0, 2); k > 0; --k)
    {
        for (point& x : sheet.points)
        {
            x = point(x.y(), x.z(), x.x());
        }
    }
    sheet.patchIDs = labelList(sheet.faces.size(), Zero);
    sheet.patchNames = wordList({"sheet"});

    return sheet;
}


//- Puts a surface into a box, at random or so that its points may be on points
//  of others
static void putInBox(Random& random, wallSurface& surface)
{
    if (randomSurfaces::chance(random, 0.4))
    {
        surface.points =
            (randomSurfaces::rotation(random) & surface.points)();
    }
    const bool isOnGrid = randomSurfaces::chance(random, 0.6);
    vector centre;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar x = random.position<scalar>(0, 2);
        centre[d] = isOnGrid ? 0.5*label(2*x + 0.5) : x;
    }
    const scalar size =
        isOnGrid ? random.position<label>(1, 2)
      : random.position<scalar>(0.3, 2.5);
    for (point& x : surface.points)
    {
        x = size*x + centre;
    }
}


//- Turns a surface, and rounds its points to single precision
static void turnAndRound(Random& random, wallSurface& all)
{
    if (randomSurfaces::chance(random, 0.5))
    {
        const tensor turn(randomSurfaces::rotation(random));
        all.points = (turn & all.points)();
    }
    if (randomSurfaces::chance(random, 0.5))
    {
        for (point& x : all.points)
        {
            for (direction d = 0; d < 3; ++d)
            {
                x[d] = float(x[d]);
            }
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallSurface assemblyInBox(Random& random)
{
    wallSurface solids
    (
        randomSurfaces::chance(random, 0.2)
      ? randomSurfaces::assembly(random) : bodiesInRow(random)
    );
    solids.patchIDs = labelList(solids.faces.size(), Zero);
    solids.patchNames = wordList({"solids"});
    wallSurface box(testSurfaces::cube(2));
    box.patchNames = wordList({"box"});
    const scalar least = random.position<scalar>(-0.9, -0.5);
    const scalar low = randomSurfaces::chance(random, 0.5) ? -0.5 : least;
    const scalar high = randomSurfaces::chance(random, 0.5) ? 2.5 : 3;
    for (point& x : box.points)
    {
        x = low*vector::one + (high - low)*x;
    }

    wallSurface all(testSurfaces::merge(box, solids));
    turnAndRound(random, all);

    return all;
}


wallSurface sheetsInBox(Random& random)
{
    wallSurface all(testSurfaces::cube(2));
    all.patchNames = wordList({"box"});
    const scalar low = randomSurfaces::chance(random, 0.5) ? 0 : -0.8;
    for (point& x : all.points)
    {
        x = low*vector::one + (2.5 - low)*x;
    }
    if (randomSurfaces::chance(random, 0.4))
    {
        wallSurface body(testSurfaces::cube(random.position<label>(1, 3)));
        body.patchNames = wordList({"solids"});
        putInBox(random, body);
        all = testSurfaces::merge(all, body);
    }
    for (label n = random.position<label>(1, 4); n > 0; --n)
    {
        wallSurface sheet(randomSheet(random));
        putInBox(random, sheet);
        all = testSurfaces::merge(all, sheet);
    }
    turnAndRound(random, all);

    return all;
}

} // End namespace Foam

// ************************************************************************* //
