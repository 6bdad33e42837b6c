/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "endedFarField.H"
#include "openSurfaces.H"
#include "thrownMessage.H"

#include <vector>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Made once: all tests look at the same
static const std::vector<endedFarField>& cases()
{
    static std::vector<endedFarField> list;

    if (list.empty())
    {
        list.reserve(10);
        for (const auto type : {farFieldType::tet, farFieldType::hexCore})
        {
            const auto add = [&]
            (
                const std::string& name, const wallSurface& wall,
                const boundBox& box
            )
            {
                list.emplace_back
                (
                    name + " in " + farFieldTypes[int(type)], wall, box,
                    farBoundaryType::box, type
                );
            };
            const boundBox around(point(-2, -2, -1), point(3, 3, 2));
            const boundBox aside(point(-2, 0, -1), point(3, 3, 2));

            const wordList ends({"inlet", "outlet"});

            // The box ends on the planes, or goes on beyond them
            add
            (
                "half sphere", endedOn(halfSphere(6), halfPlanes()),
                boundBox(point(-3, -3, 0), point(3, 3, 3))
            );
            add("half cube", endedOn(halfCube(4), halfPlanes()), around);
            add
            (
                "quarter cube", endedOn(quarterCube(4), quarterPlanes()), aside
            );
            add("duct", endedOn(duct(4), ends), boundBox());
            add("half duct", halfOf(duct(4)), boundBox());
        }
    }

    return list;
}


//- The box in front of the planes, without the body
static scalar volumeOf(const endedFarField& c)
{
    if (c.box.empty())
    {
        return c.name.find("half") == std::string::npos ? 1 : 0.5;
    }
    const bool isQuarter = c.wall.border.sides.size() == 2;
    const vector size
    (
        c.box.max() - point(c.box.min().x(), isQuarter ? 0 : c.box.min().y(), 0)
    );

    return cmptProduct(size) - volumeTo(c.wall, Zero);
}


static std::string errorOf
(
    const boundBox& box,
    const farBoundaryType type = farBoundaryType::box
)
{
    return thrownMessage<error>
    (
        [&]()
        {
            endedFarField("", endedOn(halfCube(4), halfPlanes()), box, type);
        }
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(endedFarField, volumesSumToThatOfTheFluid)
{
    for (const endedFarField& c : cases())
    {
        EXPECT_NEAR(sum(c.mesh().cellVolumes()), volumeOf(c), 1e-9) << c.name;
        EXPECT_GT(min(c.mesh().cellVolumes()), 0) << c.name;
    }
}


TEST(endedFarField, meshIsConformalAndSound)
{
    for (const endedFarField& c : cases())
    {
        EXPECT_FALSE(c.mesh().checkTopology(false)) << c.name;
        EXPECT_FALSE(c.mesh().checkUpperTriangular(false)) << c.name;
        EXPECT_FALSE(c.mesh().checkFacePyramids(false)) << c.name;
        EXPECT_FALSE(c.mesh().checkClosedBoundary(false)) << c.name;
        EXPECT_FALSE(c.mesh().checkClosedCells(false)) << c.name;
        EXPECT_FALSE(c.mesh().checkFaceOrthogonality(false)) << c.name;
        EXPECT_EQ
        (
            c.mesh().nCells(),
            nLayers*c.wall.faces.size() + c.far.nCells
        )   << c.name;
    }
}


TEST(endedFarField, patchesAreThoseOfWallSidesAndBox)
{
    const auto names = [](const label i)
    {
        return cases()[i].mesh().boundaryMesh().names();
    };
    const auto sorted = [](wordList list)
    {
        std::sort(list.begin(), list.end());
        return list;
    };

    for (const label first : {0, 5})
    {
        for (const label i : {first, first + 1})
        {
            EXPECT_EQ
            (
                sorted(names(i)),
                wordList
                ({"bottom", "wall", "xMax", "xMin", "yMax", "yMin", "zMax"})
            );
        }
        EXPECT_EQ
        (
            sorted(names(first + 2)),
            wordList
            ({"bottom", "side", "wall", "xMax", "xMin", "yMax", "zMax"})
        );
        EXPECT_EQ
        (
            sorted(names(first + 3)), wordList({"inlet", "outlet", "walls"})
        );
    }

    const polyBoundaryMesh& patches = cases()[0].mesh().boundaryMesh();
    EXPECT_EQ(patches["bottom"].type(), "symmetryPlane");
    EXPECT_EQ(patches["wall"].type(), "wall");
    EXPECT_EQ(patches["zMax"].type(), "patch");
}


TEST(endedFarField, sidePatchesAreAllOfThePlaneButTheBody)
{
    for (const label first : {0, 5})
    {
        const auto area = [&](const label i, const word& patch)
        {
            return cases()[first + i].area(patch);
        };
        EXPECT_NEAR(area(1, "bottom"), 25 - 1, 1e-12);
        EXPECT_NEAR(area(1, "xMin"), 5*2, 1e-12);
        EXPECT_NEAR(area(2, "bottom"), 5*3 - 0.5, 1e-12);
        EXPECT_NEAR(area(2, "side"), 5*2 - 0.5, 1e-12);
        EXPECT_NEAR(area(3, "inlet"), 1, 1e-12);
        EXPECT_NEAR(area(3, "outlet"), 1, 1e-12);
    }
}


TEST(endedFarField, hexahedraStayOnPlanes)
{
    for (label i = 5; i < 8; ++i)
    {
        const endedFarField& c = cases()[i];
        const cellZone& core = c.mesh().cellZones()["hexCore"];
        const polyPatch& bottom = c.mesh().boundaryMesh()["bottom"];
        scalar area = 0;
        forAll(bottom, k)
        {
            if (core.whichCell(bottom.faceCells()[k]) >= 0)
            {
                area += bottom[k].mag(c.mesh().points());
            }
        }
        EXPECT_GT(area, 0.5*c.area("bottom")) << c.name;
    }
}


TEST(endedFarField, sidePatchesArePlane)
{
    for (const endedFarField& c : cases())
    {
        for (const sidePatch& side : c.wall.border.sides)
        {
            const polyPatch& patch = c.mesh().boundaryMesh()[side.name];
            for (const point& x : patch.localPoints())
            {
                EXPECT_NEAR(side.distance(x), 0, 1e-12) << c.name;
            }
            for (const vector& n : patch.faceNormals())
            {
                EXPECT_LT(mag(n - side.normal), 1e-9) << c.name;
            }
        }
    }
}


TEST(endedFarField, sidePatchesBeginWithTheSidesOfTheLayers)
{
    // Those are of cells of the layers, the others of the far field
    for (const endedFarField& c : cases())
    {
        forAll(c.wall.border.sides, s)
        {
            const polyPatch& patch =
                c.mesh().boundaryMesh()[c.wall.border.sides[s].name];
            const label n = nLayers*nEdgesOn(c.wall.border, s);
            const label nLayerCells = nLayers*c.wall.faces.size();
            forAll(patch, i)
            {
                EXPECT_EQ(patch.faceCells()[i] < nLayerCells, i < n) << c.name;
            }
            EXPECT_GT(patch.size(), n) << c.name;
        }
    }
}


TEST(endedFarField, groundOfABox)
{
    const endedFarField c
    (
        "ground",
        endedOn
        (
            sheet(6, 0),
            List<sidePatch>
            ({
                symmetryPlane("west", Zero, vector(-1, 0, 0)),
                symmetryPlane("east", point(1, 0, 0), vector(1, 0, 0)),
                symmetryPlane("south", Zero, vector(0, -1, 0)),
                symmetryPlane("north", point(0, 1, 0), vector(0, 1, 0))
            })
        ),
        boundBox(point(0, 0, -1), point(1, 1, 2))
    );

    EXPECT_NEAR(sum(c.mesh().cellVolumes()), 2, 1e-12);
    EXPECT_EQ(c.mesh().boundaryMesh().size(), 6);
    for (const word side : {"west", "east", "south", "north"})
    {
        EXPECT_NEAR(c.area(side), 2, 1e-12);
    }
    EXPECT_NEAR(c.area("zMax"), 1, 1e-12);
    EXPECT_FALSE(c.mesh().checkTopology(false));
    EXPECT_FALSE(c.mesh().checkClosedBoundary(false));
}


TEST(endedFarField, bodyFromOnePlaneToAnother)
{
    // The cube without its sides at x = 0 and x = 1
    wallSurface tube(beyond(quadCube(4), vector::X, 1e-6));
    for (point& x : tube.points)
    {
        x.x() = 1 - x.x();
    }
    tube = beyond(reversed(tube), vector::X, 1e-6);

    const endedFarField c
    (
        "tube",
        endedOn
        (
            tube,
            List<sidePatch>
            ({
                symmetryPlane("west", Zero, vector(-1, 0, 0)),
                symmetryPlane("east", point(1, 0, 0), vector(1, 0, 0))
            })
        ),
        boundBox(point(-1, -1, -1), point(2, 2, 2))
    );

    EXPECT_EQ(c.wall.faces.size(), 64);
    EXPECT_NEAR(sum(c.mesh().cellVolumes()), 9 - 1, 1e-12);
    EXPECT_NEAR(c.area("west"), 9 - 1, 1e-12);
    EXPECT_NEAR(c.area("east"), 9 - 1, 1e-12);
    EXPECT_NEAR(c.area("zMin"), 3, 1e-12);
    EXPECT_FALSE(c.mesh().checkTopology(false));
    EXPECT_FALSE(c.mesh().checkClosedBoundary(false));
}


TEST(endedFarField, boundariesInTheWrongPlaceAreRefused)
{
    // Cuts the layers, which are up to x = 1.1, and does not hold the plane
    expectWords
    (
        errorOf(boundBox(point(-2, -2, 0), point(1.05, 3, 2))),
        {"not around the wall", "are outside of it"}
    );
    expectWords
    (
        errorOf(boundBox(point(-2, -2, 0.2), point(3, 3, 2))),
        {"not around the wall"}
    );
    // The layers end at z = 0.6
    expectWords
    (
        errorOf(boundBox(point(-2, -2, 0), point(3, 3, 0.55))),
        {"cuts the layers", "first at ("}
    );
}


TEST(endedFarField, planesNeedABox)
{
    expectWords
    (
        errorOf
        (
            boundBox(point(-9, -9, -9), point(9, 9, 9)),
            farBoundaryType::sphere
        ),
        {"With side planes", "box"}
    );
    expectWords
    (
        errorOf(boundBox()),
        {"boundary { type box;"}
    );
}


// ************************************************************************* //
