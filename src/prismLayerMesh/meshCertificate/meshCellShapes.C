/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCell.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const Enum<meshCellShape> meshCellShapeName
({
    {meshCellShape::prism, "prism"},
    {meshCellShape::lyingPrism, "lyingPrism"},
    {meshCellShape::hexahedron, "hexahedron"},
    {meshCellShape::wedge, "wedge"},
    {meshCellShape::tetrahedron, "tetrahedron"},
    {meshCellShape::box, "box"},
    {meshCellShape::other, "other"},
    {meshCellShape::polyhedron, "polyhedron"}
});


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label meshCell::faceOf(const label n, label i) const
{
    while (nPoints(i) != n)
    {
        ++i;
    }

    return i;
}


bool meshCell::isTriangle
(
    const label i,
    const label a,
    const label b,
    const label c
) const
{
    for (label k = 0; k < 3; ++k)
    {
        if (corner(i, k) == a)
        {
            return corner(i, k + 1) == b && corner(i, k + 2) == c;
        }
    }

    return false;
}


bool meshCell::readSide(const label i, label* p, label* above) const
{
    for (label k = 0; k < 3; ++k)
    {
        for (label j = 0; j < 4; ++j)
        {
            if
            (
                corner(i, j) == p[k]
             && corner(i, j + 1) == p[(k + 1)%3]
             && p[k + 3] < 0
            )
            {
                above[(k + 1)%3] = corner(i, j + 2);
                p[k + 3] = corner(i, j + 3);

                return true;
            }
        }
    }

    return false;
}


bool meshCell::asPrism(label* p) const
{
    if (nFaces() != 5 || nTriangles_ != 2 || nQuads_ != 3)
    {
        return false;
    }

    const label lower = faceOf(3);
    const label upper = faceOf(3, lower + 1);

    // From inside, the order is the reverse
    for (label k = 0; k < 3; ++k)
    {
        p[k] = corner(lower, 2 - k);
        p[k + 3] = -1;
    }

    label above[3];

    for (label i = 0; i < 5; ++i)
    {
        if (nPoints(i) == 4 && !readSide(i, p, above))
        {
            return false;
        }
    }

    for (label k = 0; k < 3; ++k)
    {
        for (label j = 0; j < 3; ++j)
        {
            if (above[k] != p[k + 3] || p[k + 3] == p[j])
            {
                return false;
            }
        }
    }

    return isTriangle(upper, p[3], p[4], p[5]);
}


bool meshCell::asWedge(label* p) const
{
    if (nFaces() != 4 || nTriangles_ != 2 || nQuads_ != 2)
    {
        return false;
    }

    const label a = faceOf(4);
    const label b = faceOf(4, a + 1);

    // The point between the two common edges
    for (label i = 0; i < 4; ++i)
    {
        for (label j = 0; j < 4; ++j)
        {
            if
            (
                corner(a, i) == corner(b, j)
             && corner(a, i + 1) == corner(b, j + 3)
             && corner(a, i + 3) == corner(b, j + 1)
            )
            {
                // A prism of which two lower points are one
                p[0] = p[1] = corner(a, i + 1);
                p[2] = corner(a, i);
                p[3] = corner(a, i + 2);
                p[4] = corner(b, j + 2);
                p[5] = corner(a, i + 3);

                const label s = faceOf(3);
                const label t = faceOf(3, s + 1);

                return
                    (isTriangle(s, p[3], p[4], p[5])
                  && isTriangle(t, p[0], p[4], p[3]))
                 || (isTriangle(t, p[3], p[4], p[5])
                  && isTriangle(s, p[0], p[4], p[3]));
            }
        }
    }

    return false;
}

} // End namespace Foam

// ************************************************************************* //
