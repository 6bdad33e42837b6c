/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wrapSurface.H"
#include "openSurfaces.H"
#include "thrownMessage.H"
#include "wallDefects.H"

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A cube without one of its triangles
static wallSurface leakyCube(const label n)
{
    wallSurface surface(cube(n));
    surface.faces.setSize(surface.faces.size() - 1);
    surface.patchIDs.setSize(surface.faces.size());

    return surface;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wrapSurface, closesHolesNarrowerThanTheSize)
{
    // The hole is 0.29 across
    const wallSurface wrap(wrapSurface(leakyCube(2), 0.4, 0.02, pointField()));

    EXPECT_TRUE(findWallDefects(wrap).empty());
    EXPECT_GT(testSurfaces::enclosedVolume(wrap), 1);
    EXPECT_LT(testSurfaces::enclosedVolume(wrap), 1.2);
}


TEST(wrapSurface, goesThroughWiderHoles)
{
    const wallSurface wrap(wrapSurface(leakyCube(2), 0.1, 0.01, pointField()));

    EXPECT_TRUE(findWallDefects(wrap).empty());
    EXPECT_LT(testSurfaces::enclosedVolume(wrap), 0.3);
}


TEST(wrapSurface, beginsAtSeeds)
{
    const pointField seeds(1, point(0.5, 0.5, 0.5));
    const wallSurface wrap(wrapSurface(leakyCube(4), 0.2, 0.02, seeds));
    const scalar volume = mag(testSurfaces::enclosedVolume(wrap));

    EXPECT_LT(volume, 1);
    EXPECT_GT(volume, 0.7);
}


TEST(wrapSurface, seedsOnTheSurfaceAreRefused)
{
    const pointField seeds(1, point(1, 0.5, 0.5));

    expectWords
    (
        thrownMessage<error>
        (
            [&]() { wrapSurface(cube(4), 0.2, 0.02, seeds); }
        ),
        {"is empty", "(1 0.5 0.5)", "room of about twice the size"}
    );
}


TEST(wrapSurface, sizesThatAreMuchTooSmallAreRefused)
{
    expectWords
    (
        thrownMessage<error>
        (
            [&]() { wrapSurface(cube(4), 1e-6, 1e-7, pointField()); }
        ),
        {"size 1e-06", "triangles", "0.00154919"}
    );
}


TEST(wrapLeaks, namesTheOpeningsThatTheWrapWentThrough)
{
    const wallSurface surface(leakyCube(2));
    const nearestSurface nearest(surface);

    for (const scalar size : {0.4, 0.1})
    {
        const wallSurface wrap
        (
            wrapSurface(surface, size, 0.01, pointField())
        );
        repairSteps steps;
        addLeaks(surface, facesInside(surface, nearest, wrap), size, steps);

        if (size > 0.3)
        {
            EXPECT_TRUE(steps.empty());
            continue;
        }

        ASSERT_EQ(steps.size(), 2);
        EXPECT_GT(steps[0].count, 40);
        EXPECT_NE(steps[1].what.find("openings"), std::string::npos);
        EXPECT_EQ(steps[1].count, 1);
        ASSERT_EQ(steps[1].places.size(), 1);

        // Beside the face that is missing
        const face missing(cube(2).faces.last());
        const point centre(missing.centre(cube(2).points));
        EXPECT_LT(mag(steps[1].places[0] - centre), 0.2);
    }
}


TEST(nearestSurface, chamfersGetNoPatchThatOnlyFacesAlongItHave)
{
    // A duct whose edges are cut off: four chamfers around each opening
    wallSurface around(duct(8));
    for (point& x : around.points)
    {
        const label nOut =
            (mag(x.x() - 0.5) > 0.49) + (mag(x.y() - 0.5) > 0.49)
          + (mag(x.z() - 0.5) > 0.49);
        x -= nOut > 1 ? 0.1*(x - point(0.5, 0.5, 0.5)) : vector(Zero);
    }
    const wallSurface given(duct(8));
    const nearestSurface nearest(given);
    wallSurface all(around), along(around);
    nearest.setPatches(all, wordHashSet());
    nearest.setPatches(along, wordHashSet({"inlet", "outlet"}));

    const vectorField normals(around.faceNormals());
    label nOpen = 0, nTaken = 0;
    forAll(normals, facei)
    {
        const word& name = all.patchNames[all.patchIDs[facei]];
        const word& other = along.patchNames[along.patchIDs[facei]];
        const bool isAlong = mag(normals[facei].x()) > 0.985;

        EXPECT_EQ(other, name == "walls" || isAlong ? name : "walls");
        nOpen += other != "walls";
        nTaken += other != name;
    }
    EXPECT_GT(nOpen, 50);
    EXPECT_GT(nTaken, 20);
}


TEST(snapToSurface, putsPointsOnFacesAndSharpEdges)
{
    const wallSurface body(cube(4));
    const nearestSurface nearest(body);
    wallSurface wrap(wrapSurface(body, 0.1, 0.01, pointField()));
    ASSERT_GT(distanceTo(nearest, wrap).largest, 0.009);
    const snapCounts counts
    (
        snapToSurface(body, nearest, snapControls{0.02, 30, {}, {}}, wrap)
    );

    // Where points are close to each other, flat triangles hold some back
    EXPECT_GT(counts.nOnEdges, 60);
    EXPECT_LT(counts.nLeft + counts.nHalfWay, 0.05*wrap.points.size());
    EXPECT_LT(distanceTo(nearest, wrap).largest, 0.04);
    EXPECT_LT(distanceTo(nearest, wrap).mean, 5e-4);
    EXPECT_TRUE(findWallDefects(wrap).empty());
    EXPECT_NEAR(testSurfaces::enclosedVolume(wrap), 1, 0.005);

    label nOff = 0;
    for (const point& x : wrap.points)
    {
        const vector d(cmptMag(x - point(0.5, 0.5, 0.5)));
        nOff += mag(cmptMax(d) - 0.5) > 1e-12;
    }
    EXPECT_EQ(nOff, counts.nLeft + counts.nHalfWay);
}


TEST(snapToSurface, sheetsBecomePlates)
{
    const wallSurface sheet(testSurfaces::sheet(4, 0));
    const nearestSurface nearest(sheet);
    wallSurface wrap(wrapSurface(sheet, 0.1, 0.01, pointField()));
    const pointField from(wrap.points);
    const bitSet inside(facesInside(sheet, nearest, wrap));
    EXPECT_TRUE(inside.all());

    const snapCounts counts
    (
        snapToSurface(sheet, nearest, snapControls{0.02, 30, inside, {}}, wrap)
    );

    EXPECT_EQ(counts.nLeft, wrap.points.size());
    ASSERT_EQ(wrap.points.size(), from.size());
    EXPECT_LT(max(mag(wrap.points - from)), 1e-15);

    // Twice as thick as the wrap is distant
    scalar area = 0;
    for (const face& f : sheet.faces)
    {
        area += f.mag(sheet.points);
    }
    EXPECT_NEAR(testSurfaces::enclosedVolume(wrap), 0.02*area, 0.1*0.02*area);
}


//- A box with a face less, and what is inside of it
struct wrappedFromWithin
{
    const wallSurface body;
    const nearestSurface nearest;
    wallSurface wrap;

    explicit wrappedFromWithin(const scalar size)
    :
        body(leakyCube(4)),
        nearest(body),
        wrap
        (
            wrapSurface
            (
                body, size, 0.1*size, pointField(1, point(0.5, 0.5, 0.5))
            )
        )
    {
        snapToSurface(body, nearest, snapControls{0.2*size, 30, {}, {}}, wrap);
    }
};


TEST(snapToSurface, chamfersBecomeCorners)
{
    for (const scalar size : {0.15, 0.2})
    {
        const wrappedFromWithin w(size);
        const scalar volume = testSurfaces::enclosedVolume(w.wrap);

        EXPECT_TRUE(findWallDefects(w.wrap).empty());

        // But for a few points that others keep back; 0.89 and 0.77 without
        EXPECT_NEAR(mag(volume), 1, 0.01) << size;
        EXPECT_LT(distanceTo(nearestSurface(w.wrap), w.body).mean, 2e-3);
    }
}


TEST(snapToSurface, sidePatchesArePlaneUpToTheirRims)
{
    // A duct whose first face, of the walls, is missing
    wallSurface body(duct(8));
    const label missing =
        body.patchIDs.find(body.patchNames.find("walls"));
    body.faces[missing] = body.faces.last();
    body.patchIDs[missing] = body.patchIDs.last();
    body.faces.setSize(body.faces.size() - 1);
    body.patchIDs.setSize(body.faces.size());

    bitSet sides(body.faces.size());
    forAll(body.faces, facei)
    {
        const word& name = body.patchNames[body.patchIDs[facei]];
        sides.set(facei, name != "walls");
    }

    const nearestSurface nearest(body);
    wallSurface wrap
    (
        wrapSurface(body, 0.2, 0.02, pointField(1, point(0.5, 0.5, 0.5)))
    );
    snapToSurface(body, nearest, snapControls{0.04, 30, {}, sides}, wrap);
    nearest.setPatches(wrap, wordHashSet({"inlet", "outlet"}));

    scalar area = 0;
    forAll(wrap.faces, facei)
    {
        if (wrap.patchNames[wrap.patchIDs[facei]] == "walls")
        {
            continue;
        }

        const face& f = wrap.faces[facei];
        area += f.mag(wrap.points);
        for (const label p : f)
        {
            const scalar x = wrap.points[p].x();
            EXPECT_LT(min(mag(x), mag(x - 1)), 1e-14);
        }
    }

    // Both squares
    EXPECT_NEAR(area, 2, 0.01);
}


// ************************************************************************* //
