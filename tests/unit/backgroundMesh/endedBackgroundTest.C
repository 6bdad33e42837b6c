/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "levelSetTopology.H"
#include "openSurfaces.H"
#include "testStages.H"
#include "wallDomain.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A wall that ends on side patches, and the stages up to its envelope
struct endedStages
{
    wallSurface wall;
    stages s;
    backgroundMesh mesh;

    //- Components and Euler characteristic of the wall
    label nComponents;
    label euler;


    endedStages(const wallSurface& w, const label components, const label chi)
    :
        wall(w),
        s(wall, 3, 0.15),
        mesh(s.background()),
        nComponents(components),
        euler(chi)
    {}
};


//- Made once: all tests look at the same
static const std::vector<std::unique_ptr<endedStages>>& all()
{
    static std::vector<std::unique_ptr<endedStages>> list;

    if (list.empty())
    {
        const auto add = [&](const wallSurface& w, const label n, const label e)
        {
            list.emplace_back(new endedStages(w, n, e));
        };

        // Discs, and a tube
        add(endedOn(halfCube(4), halfPlanes()), 1, 1);
        add(endedOn(halfSphere(6), halfPlanes()), 1, 1);
        add(endedOn(quarterCube(4), quarterPlanes()), 1, 1);
        add(endedOn(duct(4), wordList({"inlet", "outlet"})), 1, 0);

        // A disc again: the fluid is on one side of inlet and outlet only
        add(halfOf(duct(4)), 1, 1);
    }

    return list;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(endedBackground, envelopeEndsOnTheSidePatches)
{
    for (const auto& e : all())
    {
        const offsetEnvelope& envelope = e->s.envelope;
        const List<sidePatch>& sides = e->wall.border.sides;
        ASSERT_EQ(envelope.sides.size(), envelope.points.size());
        labelList nOn(sides.size(), Zero);

        forAll(envelope.points, i)
        {
            forAll(sides, s)
            {
                const scalar distance = sides[s].distance(envelope.points[i]);
                if (envelope.sides[i].found(s))
                {
                    EXPECT_NEAR(distance, 0, 1e-15);
                    ++nOn[s];
                }
                else
                {
                    EXPECT_LT(distance, 0);
                }
            }
        }

        EXPECT_GE(min(nOn), 5);
    }
}


TEST(endedBackground, domainIsInFrontOfTheSidePatches)
{
    for (const auto& e : all())
    {
        for (const sidePatch& side : e->wall.border.sides)
        {
            for (const tetCell& tet : e->mesh.tets)
            {
                for (const label p : tet)
                {
                    EXPECT_LE(side.distance(e->mesh.points[p]), 1e-15);
                }
            }
        }
    }
}


TEST(endedBackground, sidePatchesAreFacesOfTheDomain)
{
    // The boundary of the tetrahedra without the wall, in the plane z = 0
    const endedStages& e = *all()[0];
    const label nPoints = e.wall.points.size();
    scalar area = 0;

    forAll(e.mesh.tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            const triFace f(e.mesh.tets[t].face(i));
            bool inPlane = e.mesh.neighbours[t][i] < 0;
            for (const label p : f)
            {
                inPlane = inPlane && mag(e.mesh.points[p].z()) < 1e-15;
            }
            area += inPlane ? f.mag(e.mesh.points) : 0;
        }
    }

    // At least as far as the envelope, whose radius is 0.165
    EXPECT_GT(nPoints, 0);
    EXPECT_GT(area, 4*0.165);
}


TEST(endedBackground, levelSetsAreAsTheWall)
{
    for (const auto& e : all())
    {
        const surfaceTopology wall
        (
            wallTopology(e->wall, e->s.context.addressing)
        );

        EXPECT_EQ(wall.nComponents, e->nComponents);
        EXPECT_EQ(wall.eulerCharacteristic, e->euler);
        EXPECT_TRUE(wallLevelSetTopology(e->mesh) == wall);
    }
}


TEST(endedBackground, facetsFillTheSidePatches)
{
    // The plane of the half cube in the box; the inlet and the outlet
    const boundBox box(point(-2, -2, -2), point(3, 3, 3));
    const scalar expected[] = {25, 2};

    for (label k = 0; k < 2; ++k)
    {
        const endedStages& e = *all()[3*k];
        tetDomain domain;
        labelList triangleFace;
        domain.facets = wallTriangles(e.wall, triangleFace);
        domain.points = e.wall.points;
        domain.points.append(e.s.envelope.points);
        const label nPoints = domain.points.size();
        const label nWall = domain.facets.size();

        addSideFacets(e.wall, e.s.envelope, box, domain);

        scalar area = 0;
        for (label i = nWall; i < domain.facets.size(); ++i)
        {
            const face& f = domain.facets[i];
            const point centre(f.centre(domain.points));
            for (const sidePatch& side : e.wall.border.sides)
            {
                area += mag(side.distance(centre)) < 1e-12
                  ? f.mag(domain.points) : 0;
            }
        }

        EXPECT_NEAR(area, expected[k], 1e-12);
        for (label p = nPoints; p < domain.points.size(); ++p)
        {
            EXPECT_TRUE(box.contains(domain.points[p]));
        }
    }
}


// ************************************************************************* //
