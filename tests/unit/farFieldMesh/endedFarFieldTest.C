/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makeFarFieldMesh.H"
#include "makeSizeBounds.H"
#include "memoryMesh.H"
#include "openSurfaces.H"
#include "testStages.H"
#include "thrownMessage.H"

#include <memory>
#include <vector>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const label nLayers = 3;


//- Layers that end on side patches, with a far field in a box, or without one
struct endedFarField
{
    std::string name;
    wallSurface wall;
    boundBox box;
    prismLayers layers;
    farFieldMesh far;
    std::unique_ptr<memoryMesh> memory;


    endedFarField
    (
        const std::string& n,
        const wallSurface& w,
        const boundBox& b,
        const word& type = "box"
    )
    :
        name(n),
        wall(w),
        box(b)
    {
        const prismLayerMesh run(layeredMesh(wall, nLayers, 0.1));
        layers = run.made.layers;
        farFieldControls controls;
        controls.type = "tet";
        farBoundary boundary;
        if (!box.empty())
        {
            controls.boundary.type = type;
            controls.boundary.box = box;
            controls.boundary.radius = 0.5*box.mag();
            boundary = makeFarBoundary
            (
                controls.boundary, [](const fileName& file) { return file; }
            );
        }
        const autoPtr<Time> time(Time::New());
        far = makeFarFieldMesh
        (
            layers, run.front.addressing, boundary, controls,
            makeSizeBounds(controls, time())
        );
        prismLayers copy(layers);
        memory.reset(new memoryMesh(copy, far));
    }


    const polyMesh& mesh() const { return (*memory)(); }


    //- Area of a patch of the mesh
    scalar area(const word& patch) const
    {
        const polyPatch& faces = mesh().boundaryMesh()[patch];
        scalar sum = 0;
        for (const face& f : faces)
        {
            sum += f.mag(mesh().points());
        }

        return sum;
    }
};


//- Made once: all tests look at the same
static const std::vector<endedFarField>& cases()
{
    static std::vector<endedFarField> list;

    if (list.empty())
    {
        list.reserve(5);
        // The box ends on the planes, or goes on beyond them
        list.emplace_back
        (
            "half sphere", endedOn(halfSphere(6), halfPlanes()),
            boundBox(point(-3, -3, 0), point(3, 3, 3))
        );
        list.emplace_back
        (
            "half cube", endedOn(halfCube(4), halfPlanes()),
            boundBox(point(-2, -2, -1), point(3, 3, 2))
        );
        list.emplace_back
        (
            "quarter cube", endedOn(quarterCube(4), quarterPlanes()),
            boundBox(point(-2, 0, -1), point(3, 3, 2))
        );
        list.emplace_back
        (
            "duct", endedOn(duct(4), wordList({"inlet", "outlet"})), boundBox()
        );
        list.emplace_back("half duct", halfOf(duct(4)), boundBox());
    }

    return list;
}


//- The box in front of the planes, without the body
static scalar volumeOf(const endedFarField& c)
{
    if (c.box.empty())
    {
        return c.name == "duct" ? 1 : 0.5;
    }
    const bool isQuarter = c.wall.border.sides.size() == 2;
    const vector size
    (
        c.box.max() - point(c.box.min().x(), isQuarter ? 0 : c.box.min().y(), 0)
    );

    return cmptProduct(size) - volumeTo(c.wall, Zero);
}


static std::string errorOf(const boundBox& box, const word& type)
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
            nLayers*c.wall.faces.size() + c.far.tets.size()
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

    for (const label i : {0, 1})
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
        sorted(names(2)),
        wordList({"bottom", "side", "wall", "xMax", "xMin", "yMax", "zMax"})
    );
    EXPECT_EQ(sorted(names(3)), wordList({"inlet", "outlet", "walls"}));

    const polyBoundaryMesh& patches = cases()[0].mesh().boundaryMesh();
    EXPECT_EQ(patches["bottom"].type(), "symmetryPlane");
    EXPECT_EQ(patches["wall"].type(), "wall");
    EXPECT_EQ(patches["zMax"].type(), "patch");
}


TEST(endedFarField, sidePatchesAreAllOfThePlaneButTheBody)
{
    EXPECT_NEAR(cases()[1].area("bottom"), 25 - 1, 1e-12);
    EXPECT_NEAR(cases()[1].area("xMin"), 5*2, 1e-12);
    EXPECT_NEAR(cases()[2].area("bottom"), 5*3 - 0.5, 1e-12);
    EXPECT_NEAR(cases()[2].area("side"), 5*2 - 0.5, 1e-12);
    EXPECT_NEAR(cases()[3].area("inlet"), 1, 1e-12);
    EXPECT_NEAR(cases()[3].area("outlet"), 1, 1e-12);
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
    // Those are quadrilaterals, the others triangles
    for (const endedFarField& c : cases())
    {
        forAll(c.wall.border.sides, s)
        {
            const polyPatch& patch =
                c.mesh().boundaryMesh()[c.wall.border.sides[s].name];
            label nQuads = 0;
            for (const face& f : patch)
            {
                nQuads += f.size() == 4;
            }
            EXPECT_EQ(nQuads, nLayers*nEdgesOn(c.wall.border, s)) << c.name;
            EXPECT_GT(patch.size(), nQuads) << c.name;
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
        errorOf(boundBox(point(-2, -2, 0), point(1.05, 3, 2)), "box"),
        {"not around the wall", "are outside of it"}
    );
    expectWords
    (
        errorOf(boundBox(point(-2, -2, 0.2), point(3, 3, 2)), "box"),
        {"not around the wall"}
    );
    // The layers end at z = 0.6
    expectWords
    (
        errorOf(boundBox(point(-2, -2, 0), point(3, 3, 0.55)), "box"),
        {"cuts the layers", "first at ("}
    );
}


TEST(endedFarField, planesNeedABox)
{
    expectWords
    (
        errorOf(boundBox(point(-9, -9, -9), point(9, 9, 9)), "sphere"),
        {"With side planes", "box"}
    );
    expectWords
    (
        errorOf(boundBox(), "box"),
        {"boundary of type box"}
    );
}


// ************************************************************************* //
