/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "makePrismLayers.H"
#include "editedColumns.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Layers on a wall, and the causes that are named of them
struct namedColumns
{
    wallSurface wall;
    wallAddressing addressing;
    editedColumns m;
    layerSpacing asked;
    madeLayers made;

    explicit namedColumns(const wallSurface& w)
    :
        wall(w),
        addressing(makeWallAddressing(wall)),
        m(testSurfaces::frontOf(wall, 0)),
        asked(m.spacing),
        made
        {
            m.editor.layers(), m.editor.thickness(), m.editor.causes(),
            labelList(), certification()
        }
    {}

    //- The point nearest to a place
    label pointAt(const point& x) const
    {
        return findMin(scalarField(mag(wall.points - x)));
    }

    //- Bring a column down to a share of its height
    void lower(const label c, const scalar share)
    {
        for (label i = 1; i <= made.layers.nLayers; ++i)
        {
            point& x = made.layers.points[made.layers.index(c, i)];
            x = made.layers(c, 0) + share*(x - made.layers(c, 0));
        }
    }

    squeezeCause causeOf(const label c)
    {
        nameCauses
        (
            m.front,
            kindsOfPoints
            (
                wall, addressing, makeWallVisibility(wall, addressing)
            ),
            asked,
            m.spacing,
            m.columns,
            made
        );

        return made.causes[c];
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(nameCauses, lowColumnsThatGaveWayHaveTheCauseQuality)
{
    namedColumns named(testSurfaces::sphere(8));
    const label c = 20;
    named.lower(c, 0.5);
    named.made.gaveWay = labelList(1, c);

    EXPECT_EQ(named.causeOf(c), squeezeCause::quality);

    // Its neighbours did not, nor do columns that gave way without becoming low
    const label beside = named.addressing.pointPoints[c][0];
    EXPECT_EQ(named.made.causes[beside], squeezeCause::validity);
    namedColumns full(testSurfaces::sphere(8));
    full.made.gaveWay = labelList(1, c);
    EXPECT_EQ(full.causeOf(c), squeezeCause::none);
}


TEST(nameCauses, fullColumnsHaveNone)
{
    namedColumns named(testSurfaces::sphere(8));
    named.causeOf(0);

    for (const squeezeCause cause : named.made.causes)
    {
        EXPECT_EQ(cause, squeezeCause::none);
    }
}


TEST(nameCauses, lowColumnsHaveACause)
{
    namedColumns named(testSurfaces::sphere(8));
    named.lower(5, 0.8);

    EXPECT_EQ(named.causeOf(5), squeezeCause::validity);
}


TEST(nameCauses, facesWithLowFirstLayersHaveOne)
{
    // One of three columns by a tenth, of the first layer alone
    namedColumns named(testSurfaces::sphere(8));
    point& x = named.made.layers.points[named.made.layers.index(5, 1)];
    x = named.made.layers(5, 0) + 0.9*(x - named.made.layers(5, 0));

    EXPECT_EQ(named.causeOf(5), squeezeCause::validity);
}


TEST(nameCauses, concaveCornersAndNarrowConesAreToldApart)
{
    namedColumns block(testSurfaces::lBlock(4));
    forAll(block.made.causes, c)
    {
        block.made.causes[c] = squeezeCause::validity;
    }
    block.causeOf(0);

    label nHollow = 0;
    forAll(block.wall.points, p)
    {
        nHollow +=
            block.made.causes[p] == squeezeCause::concaveCorner;
    }
    EXPECT_GT(nHollow, 5);
    EXPECT_LT(nHollow, block.wall.points.size()/2);

    // A solid of three sides with a convex edge of 27 degrees
    namedColumns wedge
    (
        testSurfaces::extruded
        (
            {vector2D(0, 0), vector2D(1, 0), vector2D(1, 0.5)}, 1, 0.25
        )
    );
    forAll(wedge.made.causes, c)
    {
        wedge.made.causes[c] = squeezeCause::validity;
    }
    wedge.causeOf(0);

    label nNarrow = 0;
    forAll(wedge.wall.points, p)
    {
        const bool narrow = wedge.m.front.visibility.cones[p].cosine < 0.5;
        nNarrow += narrow;

        EXPECT_EQ(wedge.made.causes[p] == squeezeCause::visibility, narrow);
    }
    EXPECT_GT(nNarrow, 0);
    EXPECT_LT(nNarrow, wedge.wall.points.size());
}


TEST(nameCauses, otherCausesStay)
{
    namedColumns named(testSurfaces::sphere(8));
    named.made.causes[3] = squeezeCause::gap;
    named.made.causes[4] = squeezeCause::intersection;
    named.lower(3, 0.5);

    EXPECT_EQ(named.causeOf(3), squeezeCause::gap);
    EXPECT_EQ(named.made.causes[4], squeezeCause::intersection);
}


TEST(nameCauses, transitionsAreNamedWhereNothingElseIs)
{
    namedColumns named(testSurfaces::sphere(8));
    named.asked.firstThickness[7] *= 2;
    named.asked.thickness[8] *= 2;
    named.made.causes[8] = squeezeCause::gap;

    EXPECT_EQ(named.causeOf(7), squeezeCause::transition);
    EXPECT_EQ(named.made.causes[8], squeezeCause::gap);
}


// ************************************************************************* //
