/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerEditor.H"
#include "HashSet.H"
#include "ListOps.H"
#include "testSurfaces.H"

#include <algorithm>

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static labelList coloursOf(const wallSurface& wall)
{
    return columnColours(wall.faces, makeWallAddressing(wall).pointFaces);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(columnColours, columnsOfAFaceDiffer)
{
    for
    (
        const wallSurface& wall
      : {testSurfaces::sphere(10), testSurfaces::quadSphere(10)}
    )
    {
        const labelList colours(coloursOf(wall));

        EXPECT_EQ(min(colours), 0);
        EXPECT_LE(max(colours), 12);

        for (const face& f : wall.faces)
        {
            EXPECT_EQ
            (
                labelHashSet(UIndirectList<label>(colours, f)).size(), f.size()
            );
        }
    }
}


TEST(columnColours, orderOfFacesChangesNothing)
{
    wallSurface wall(testSurfaces::sphere(10));
    const labelList before(coloursOf(wall));
    std::reverse(wall.faces.begin(), wall.faces.end());

    EXPECT_EQ(coloursOf(wall), before);
}


TEST(columnColours, farColumnsChangeNothing)
{
    // As they would if colours followed each other along the labels
    wallSurface wall(testSurfaces::sphere(20));
    const labelList before(coloursOf(wall));
    const face& f = wall.faces[0];
    wall.faces.append(face({f[0], f[1], wall.points.size()}));
    wall.patchIDs.append(0);
    wall.points.append(point(2, 2, 2));

    const labelListList columnFaces
    (
        invertManyToMany<face, labelList>(wall.points.size(), wall.faces)
    );
    const labelList after(columnColours(wall.faces, columnFaces));
    label nChanged = 0;
    forAll(before, c)
    {
        nChanged += before[c] != after[c];
    }

    EXPECT_LT(nChanged, before.size()/50);
}


// ************************************************************************* //
