/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ListOps.H"
#include "openSurfaces.H"
#include "sideParts.H"
#include "thrownMessage.H"

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sideBorders, edgesWithOneFaceAreOnTheNearestPlane)
{
    const wallSurface body(quarterCube(4));
    sideParts none;
    none.sideOfFace = labelList(body.faces.size(), -1);
    const sideBorders borders
    (
        findSideBorders(body, none, quarterPlanes(), 1e-9)
    );

    EXPECT_EQ(borders.edges.size(), 16);
    EXPECT_EQ(findIndices(borders.edgeSides, 0).size(), 8);
    EXPECT_EQ(findIndices(borders.edgeSides, 1).size(), 8);

    const List<sidePatch> planes(quarterPlanes());
    forAll(borders.edges, i)
    {
        const edge& e = borders.edges[i];
        const sidePatch& plane = planes[borders.edgeSides[i]];
        EXPECT_TRUE
        (
            plane.hasEdge(body.points[e.first()], body.points[e.second()], 1e-9)
        );
        EXPECT_TRUE
        (
            borders.pointSides[e.first()].found(borders.edgeSides[i])
        );
    }
}


TEST(sideBorders, edgesBesideAPartAreOfTheWallsFaces)
{
    wallSurface surface(duct(3));
    const sideParts parts
    (
        findSideParts(surface, withoutLayers({"inlet"}), 1e-6)
    );
    const sideBorders borders(findSideBorders(surface, parts, {}, 1e-6));

    EXPECT_EQ(borders.edges.size(), 12);
    EXPECT_EQ(borders.edgeSides, labelList(12, Zero));

    // All points of the inlet
    label nOnSide = 0;
    for (const labelList& sides : borders.pointSides)
    {
        nOnSide += sides.size();
    }
    EXPECT_EQ(nOnSide, 16);
}


TEST(sideBorders, bordersFarFromAllPlanesAreRefused)
{
    const wallSurface body(halfCube(2));
    sideParts none;
    none.sideOfFace = labelList(body.faces.size(), -1);

    expectWords
    (
        thrownMessage<error>
        (
            [&]() { findSideBorders(body, none, {}, 1e-6); }
        ),
        {"its border is further than 1e-06 m"}
    );
}


// ************************************************************************* //
