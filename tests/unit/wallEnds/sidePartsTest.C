/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "sideParts.H"
#include "wallSides.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static sideParts partsOf
(
    wallSurface& surface,
    const wordList& patches,
    const scalar tolerance = 1e-6
)
{
    return findSideParts(surface, withoutLayers(patches), tolerance);
}


//- Area of each part, by faces
static scalarField areas(const wallSurface& surface, const sideParts& parts)
{
    scalarField sums(parts.sides.size(), 0);

    forAll(surface.faces, facei)
    {
        const label s = parts.sideOfFace[facei];
        if (s >= 0)
        {
            sums[s] += surface.faces[facei].mag(surface.points);
        }
    }

    return sums;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sideParts, ofPatchesWithoutLayersOnly)
{
    wallSurface surface(duct(3));
    const sideParts parts(partsOf(surface, {"outlet"}));

    ASSERT_EQ(parts.sides.size(), 1);
    EXPECT_EQ(parts.sides[0].name, "outlet");
    EXPECT_TRUE(parts.sides[0].faces.empty());

    forAll(surface.faces, facei)
    {
        EXPECT_EQ
        (
            parts.sideOfFace[facei], surface.patchIDs[facei] == 2 ? 0 : -1
        );
    }
}


TEST(sideParts, normalsPointOutOfTheFluid)
{
    wallSurface surface(duct(3));
    const sideParts parts(partsOf(surface, {"inlet", "outlet"}));

    ASSERT_EQ(parts.sides.size(), 2);
    EXPECT_LT(mag(parts.sides[0].normal - vector(-1, 0, 0)), 1e-15);
    EXPECT_LT(mag(parts.sides[1].normal - vector(1, 0, 0)), 1e-15);
    EXPECT_LT(mag(parts.sides[0].origin - point(0, 0.5, 0.5)), 1e-15);
    EXPECT_LT(mag(parts.sides[1].origin - point(1, 0.5, 0.5)), 1e-15);
}


TEST(sideParts, sharpEdgesDivideAPatch)
{
    wallSurface surface(duct(3));
    surface.patchNames = wordList({"around", "wall", "wall2"});
    const sideParts parts(partsOf(surface, {"around"}));

    ASSERT_EQ(parts.sides.size(), 4);
    vectorField normals(4);
    forAll(normals, s)
    {
        EXPECT_EQ(parts.sides[s].name, "around");
        EXPECT_NEAR(areas(surface, parts)[s], 1, 1e-14);
        normals[s] = parts.sides[s].normal;
    }
    EXPECT_LT(mag(sum(normals)), 1e-15);
}


TEST(sideParts, facesAroundAHoleAreNoPlane)
{
    // Their areas have no normal together
    wallSurface surface(duct(3));
    const sideParts parts(partsOf(surface, {"walls"}));

    ASSERT_EQ(parts.sides.size(), 4);
    for (const sidePatch& side : parts.sides)
    {
        EXPECT_NEAR(mag(side.normal), 1, 1e-12);
        EXPECT_NEAR(side.normal.x(), 0, 1e-12);
    }
}


TEST(sideParts, apartInAPlaneTheyAreSeveral)
{
    const wallSurface one(duct(2));
    wallSurface surface
    (
        merge(one, translated(one, vector(0, 3, 0)))
    );
    const sideParts parts(partsOf(surface, {"inlet"}));

    ASSERT_EQ(parts.sides.size(), 2);
    EXPECT_EQ(parts.sides[0].name, parts.sides[1].name);
    EXPECT_NEAR(areas(surface, parts)[1], 1, 1e-14);
}


TEST(sideParts, wrinklesWithinTheToleranceAreOfOnePart)
{
    // Faces at 60 degrees to each other, but all within 1e-4 of a plane
    wallSurface surface(duct(2));
    for (point& x : surface.points)
    {
        x.y() *= 1e-4;
        x.x() += x.x() < 0.1 && mag(x.z() - 0.5) < 0.1
          ? (mag(x.y() - 0.5e-4) < 1e-5 ? 5e-5 : -5e-5) : 0;
    }
    const label n = partsOf(surface, {"inlet"}, 1e-4).sides.size();

    EXPECT_EQ(n, 1);
}


TEST(sideParts, smallAnglesThatSumUpMakeACurvedPart)
{
    wallSurface surface(bulgedDuct(24));
    const sideParts parts(partsOf(surface, {"inlet", "outlet"}));

    ASSERT_EQ(parts.sides.size(), 2);
    EXPECT_FALSE(parts.sides[0].isCurved());
    EXPECT_EQ(parts.sides[0].name, "outlet");
    ASSERT_TRUE(parts.sides[1].isCurved());
    EXPECT_EQ(parts.sides[1].name, "inlet");
    EXPECT_LT(mag(parts.sides[1].normal - vector(-1, 0, 0)), 1e-12);

    // It is at its faces, not at the mean plane
    forAll(surface.faces, facei)
    {
        if (parts.sideOfFace[facei] == 1)
        {
            const point centre(surface.faces[facei].centre(surface.points));
            EXPECT_NEAR(parts.sides[1].distance(centre), 0, 1e-14);
        }
    }
}


TEST(sideParts, facetsThatAllTouchTheWallArePlanes)
{
    // The wall is the two caps of a prism of 48 sides, at 7.5 degrees
    List<vector2D> polygon(48);
    forAll(polygon, i)
    {
        const scalar angle = constant::mathematical::twoPi*i/polygon.size();
        polygon[i] = vector2D(::cos(angle), ::sin(angle));
    }
    wallSurface surface(extruded(polygon, 1, 0.2));
    surface.patchNames = wordList({"wall", "around"});
    forAll(surface.faces, facei)
    {
        const vector n(surface.faces[facei].unitNormal(surface.points));
        surface.patchIDs[facei] = mag(n.z()) < 0.5;
    }
    const sideParts parts(partsOf(surface, {"around"}));

    EXPECT_EQ(parts.sides.size(), 48);
    for (const sidePatch& side : parts.sides)
    {
        EXPECT_FALSE(side.isCurved());
    }
}


//- All faces of curved parts are seen along the mean normal of theirs, and the
//  parts of a patch cover it
static void expectSeen
(
    const wallSurface& surface,
    const sideParts& parts,
    const word& patch,
    const scalar area
)
{
    scalar covered = 0;
    forAll(surface.faces, facei)
    {
        const label s = parts.sideOfFace[facei];

        if (s >= 0 && parts.sides[s].name == patch)
        {
            const vector n(surface.faces[facei].unitNormal(surface.points));
            EXPECT_GT(-n & parts.sides[s].normal, 0.25) << patch;
            covered += surface.faces[facei].mag(surface.points);
        }
    }
    EXPECT_NEAR(covered, area, 1e-12*area) << patch;
}


static scalar areaOf(const wallSurface& surface, const label patchi)
{
    scalar sum = 0;
    for (const label f : findIndices(surface.patchIDs, patchi))
    {
        sum += surface.faces[f].mag(surface.points);
    }

    return sum;
}


TEST(sideParts, domesAreDividedIntoSectors)
{
    wallSurface surface(sphere(12));
    surface.patchNames = wordList({"wall", "dome"});
    forAll(surface.faces, facei)
    {
        surface.patchIDs[facei] =
            surface.faces[facei].centre(surface.points).z() > 0;
    }
    const scalar area = areaOf(surface, 1);
    const sideParts parts(partsOf(surface, {"dome"}));

    EXPECT_EQ(parts.sides.size(), 4);
    expectSeen(surface, parts, "dome", area);
}


TEST(sideParts, cylindersAreDividedIntoSectors)
{
    wallSurface surface(vessel());
    const wallSurface given(surface);
    const sideParts parts(partsOf(surface, {"around", "top"}));

    // The top in a plane, and quarters
    ASSERT_EQ(parts.sides.size(), 5);
    EXPECT_EQ(parts.sides[0].name, "top");
    expectSeen(surface, parts, "around", areaOf(given, 1));
    expectSeen(surface, parts, "top", areaOf(given, 2));

    // The faces of the wall are as they were
    for (const label f : findIndices(given.patchIDs, 0))
    {
        EXPECT_EQ(surface.faces[f], given.faces[f]);
    }

    // Faces on both sides of a cut have its points
    const wallSides edges
    (
        makeWallSides(surface.faces, surface.points.size())
    );
    EXPECT_EQ(edges.sides.size(), 2*edges.nEdges());
    EXPECT_GT(surface.points.size(), given.points.size());
}


TEST(sideParts, sectorsMeetInPlanesThroughPointsOfTheWall)
{
    wallSurface surface(vessel());
    const sideParts parts(partsOf(surface, {"around", "top"}));

    // Points of two sectors: on radii of the bottom's border, as all is upright
    List<labelHashSet> sectorsOf(surface.points.size());
    DynamicList<label> onWall;
    forAll(surface.faces, facei)
    {
        const label s = parts.sideOfFace[facei];
        for (const label p : surface.faces[facei])
        {
            if (s > 0)
            {
                sectorsOf[p].insert(s);
            }
            else if (s < 0)
            {
                onWall.append(p);
            }
        }
    }

    label nOnCuts = 0;
    forAll(sectorsOf, p)
    {
        if (sectorsOf[p].size() > 1)
        {
            ++nOnCuts;
            const point& x = surface.points[p];
            const bool above = std::any_of
            (
                onWall.begin(), onWall.end(), [&](const label q)
                {
                    const point& y = surface.points[q];
                    return sectorsOf[q].size() > 1
                        && mag(vector(x.x() - y.x(), x.y() - y.y(), 0)) < 0.05;
                }
            );
            EXPECT_TRUE(above) << x.z();
        }
    }
    EXPECT_GT(nOnCuts, 12);
}


// ************************************************************************* //
