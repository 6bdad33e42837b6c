/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "smallFarFields.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The centres of the tetrahedra, without their order
static std::multiset<std::array<scalar, 3>> centresOf(const farFieldTets& mesh)
{
    std::multiset<std::array<scalar, 3>> centres;
    for (const tetCell& tet : mesh.tets)
    {
        const point x(tet.tet(mesh.points).centre());
        centres.insert({x.x(), x.y(), x.z()});
    }

    return centres;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(renumber, keepsTheTetrahedraAndTheBoundary)
{
    const farFieldTets before(filledCube(6));
    farFieldTets mesh(before);
    renumber(mesh);

    EXPECT_NE(mesh.tets, before.tets);
    EXPECT_EQ(centresOf(mesh), centresOf(before));
    EXPECT_EQ
    (
        mesh.neighbours, tetNeighbours(mesh.tets, mesh.points.size())
    );
    for (label p = 0; p < mesh.nBoundaryPoints; ++p)
    {
        EXPECT_EQ(mesh.points[p], before.points[p]);
    }
}


TEST(renumber, putsTetrahedraInTheOrderOfTheirFirstPoints)
{
    farFieldTets mesh(filledCube(6));
    renumber(mesh);
    label last = 0;
    for (const tetCell& tet : mesh.tets)
    {
        const label first = *std::min_element(tet.begin(), tet.end());
        EXPECT_GE(first, last);
        last = first;
    }
}


// ************************************************************************* //
