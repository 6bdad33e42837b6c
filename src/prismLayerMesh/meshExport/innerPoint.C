/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include "innerPoint.H"
#include "boundBox.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool Foam::findInnerPoint
(
    const faceList& triangles,
    const pointField& points,
    point& inner
)
{
    boundBox box(boundBox::invertedBox);
    for (const face& f : triangles)
    {
        box.add(points, f);
    }
    const point origin(box.midpoint());
    const scalar size = max(box.mag(), VSMALL);

    // Unknowns: the point in units of the box, and its distance, to be largest
    CGAL::Quadratic_program<double> program(CGAL::SMALLER, false, 0, false, 0);
    program.set_c(3, -1);

    forAll(triangles, i)
    {
        const vector n(normalised(triangles[i].areaNormal(points)));
        if (n == vector::zero)
        {
            return false;
        }
        program.set_a(0, i, n.x());
        program.set_a(1, i, n.y());
        program.set_a(2, i, n.z());
        program.set_a(3, i, 1);
        program.set_b(i, (n & (points[triangles[i][0]] - origin))/size);
    }

    const auto solution
    (
        CGAL::solve_linear_program(program, CGAL::Gmpzf())
    );
    if (!solution.is_optimal())
    {
        return false;
    }
    auto value = solution.variable_values_begin();
    for (direction i = 0; i < 3; ++i, ++value)
    {
        inner[i] = origin[i] + size*CGAL::to_double(*value);
    }

    return true;
}


// ************************************************************************* //
