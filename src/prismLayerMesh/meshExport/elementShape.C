/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elementShape.H"
#include "cellPredicates.H"
#include "ranges.H"

#include <array>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef std::array<int, 4> cornerPoints;

//- The tetrahedra at the corners of an element
static const std::vector<cornerPoints>& cornersOf(const elementShape shape)
{
    static const std::vector<cornerPoints> corners[] =
    {
        {{0, 1, 2, 3}},
        {{0, 1, 3, 4}, {1, 2, 0, 4}, {2, 3, 1, 4}, {3, 0, 2, 4}},
        {
            {0, 1, 2, 3}, {1, 2, 0, 4}, {2, 0, 1, 5},
            {3, 5, 4, 0}, {4, 3, 5, 1}, {5, 4, 3, 2}
        },
        {
            {0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7},
            {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3}
        }
    };

    return corners[int(shape) - int(elementShape::tetrahedron)];
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

const elementFacts& factsOf(const elementShape shape)
{
    static const elementFacts facts[nElementShapes] =
    {
        {"line", 2, 3, 1},
        {"triangle", 3, 5, 2},
        {"quadrilateral", 4, 9, 3},
        {"tetrahedron", 4, 10, 4},
        {"pyramid", 5, 14, 7},
        {"prism", 6, 13, 6},
        {"hexahedron", 8, 12, 5}
    };

    return facts[int(shape)];
}


const std::vector<face>& facesOf(const elementShape shape)
{
    static const std::vector<face> faces[nElementShapes] =
    {
        {}, {}, {},
        {face({0, 2, 1}), face({0, 1, 3}), face({1, 2, 3}), face({2, 0, 3})},
        {
            face({0, 3, 2, 1}), face({0, 1, 4}), face({1, 2, 4}),
            face({2, 3, 4}), face({3, 0, 4})
        },
        {
            face({0, 2, 1}), face({3, 4, 5}), face({0, 1, 4, 3}),
            face({1, 2, 5, 4}), face({2, 0, 3, 5})
        },
        {
            face({0, 3, 2, 1}), face({4, 5, 6, 7}), face({0, 1, 5, 4}),
            face({1, 2, 6, 5}), face({2, 3, 7, 6}), face({3, 0, 4, 7})
        }
    };

    return faces[int(shape)];
}


bool isPositive
(
    const elementShape shape,
    const UList<label>& labels,
    const pointField& points
)
{
    return allOf(cornersOf(shape), [&](const cornerPoints& c)
    {
        return orientation
        (
            points[labels[c[0]]], points[labels[c[1]]],
            points[labels[c[2]]], points[labels[c[3]]]
        ) > 0;
    });
}

} // End namespace Foam

// ************************************************************************* //
