/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "nameCauses.H"
#include "movableColumns.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Layers on a wall, and the causes that are named of them
struct namedColumns
{
    wallSurface wall;
    wallAddressing addressing;
    movableColumns m;
    layerSpacing asked;
    prismLayers layers;

    explicit namedColumns(const wallSurface& w)
    :
        wall(w),
        addressing(makeWallAddressing(wall)),
        m(testSurfaces::frontOf(wall, 0)),
        asked(m.spacing),
        layers(m.moving.layers())
    {}

    //- The point nearest to a place
    label pointAt(const point& x) const
    {
        return findMin(scalarField(mag(wall.points - x)));
    }

    //- Bring a column down to a share of its height
    void lower(const label c, const scalar share)
    {
        for (label i = 1; i <= layers.nLayers; ++i)
        {
            point& x = layers.points[layers.index(c, i)];
            x = layers(c, 0) + share*(x - layers(c, 0));
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
            layers,
            m.columns
        );

        return m.columns.causes[c];
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(nameCauses, fullColumnsHaveNone)
{
    namedColumns named(testSurfaces::sphere(8));
    named.causeOf(0);

    for (const squeezeCause cause : named.m.columns.causes)
    {
        EXPECT_EQ(cause, squeezeCause::none);
    }
}


TEST(nameCauses, whatIsLowHasOne)
{
    namedColumns named(testSurfaces::sphere(8));
    named.lower(5, 0.8);

    EXPECT_EQ(named.causeOf(5), squeezeCause::validity);
}


TEST(nameCauses, facesWithLowFirstLayersHaveOne)
{
    // One of three columns by a tenth, of the first layer alone
    namedColumns named(testSurfaces::sphere(8));
    point& x = named.layers.points[named.layers.index(5, 1)];
    x = named.layers(5, 0) + 0.9*(x - named.layers(5, 0));

    EXPECT_EQ(named.causeOf(5), squeezeCause::validity);
}


TEST(nameCauses, concaveCornersAndNarrowConesAreToldApart)
{
    namedColumns block(testSurfaces::lBlock(4));
    forAll(block.m.columns.causes, c)
    {
        block.m.columns.causes[c] = squeezeCause::validity;
    }
    block.causeOf(0);

    label nHollow = 0;
    forAll(block.wall.points, p)
    {
        nHollow +=
            block.m.columns.causes[p] == squeezeCause::concaveCorner;
    }
    EXPECT_GT(nHollow, 5);
    EXPECT_LT(nHollow, block.wall.points.size()/2);

    // A convex edge of 30 degrees
    namedColumns wedge(testSurfaces::wedgeBlock(2, 30));
    forAll(wedge.m.columns.causes, c)
    {
        wedge.m.columns.causes[c] = squeezeCause::validity;
    }
    wedge.causeOf(0);

    forAll(wedge.wall.points, p)
    {
        if (wedge.m.columns.causes[p] == squeezeCause::visibility)
        {
            EXPECT_LT(wedge.m.front.visibility.cones[p].cosine, 0.5);
        }
    }
}


TEST(nameCauses, otherCausesStay)
{
    namedColumns named(testSurfaces::sphere(8));
    named.m.columns.causes[3] = squeezeCause::gap;
    named.m.columns.causes[4] = squeezeCause::intersection;
    named.lower(3, 0.5);

    EXPECT_EQ(named.causeOf(3), squeezeCause::gap);
    EXPECT_EQ(named.m.columns.causes[4], squeezeCause::intersection);
}


TEST(nameCauses, transitionsAreNamedWhereNothingElseIs)
{
    namedColumns named(testSurfaces::sphere(8));
    named.asked.firstThickness[7] *= 2;
    named.asked.thickness[8] *= 2;
    named.m.columns.causes[8] = squeezeCause::gap;

    EXPECT_EQ(named.causeOf(7), squeezeCause::transition);
    EXPECT_EQ(named.m.columns.causes[8], squeezeCause::gap);
}


// ************************************************************************* //
