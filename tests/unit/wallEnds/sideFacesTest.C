/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openSurfaces.H"
#include "sideParts.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::testSurfaces;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sideFaces, patchesAreApartAndSectorsDivideThem)
{
    const wallSurface surface(duct(2));
    const layerControls layers(withoutLayers({"inlet", "outlet"}));
    labelList sectors(surface.faces.size(), Zero);
    const labelList noParts(surface.faces.size(), -1);

    const sideFaces whole(surface, sectors, layers);
    const List<DynamicList<label>> lists(whole.joined(0.9, noParts));
    ASSERT_EQ(lists.size(), 2);
    EXPECT_EQ(lists[0].size(), 4);
    EXPECT_EQ(lists[1].size(), 4);
    EXPECT_TRUE(whole.touchWall(lists[0]));

    sectors[lists[0][0]] = 1;
    const sideFaces divided(surface, sectors, layers);
    EXPECT_EQ(divided.joined(0.9, noParts).size(), 3);

    // Faces of parts are left out
    labelList parts(noParts);
    UIndirectList<label>(parts, lists[1]) = 0;
    EXPECT_EQ(divided.joined(0.9, parts).size(), 2);
}


TEST(sideFaces, bodyOfSideFacesIsNotJoinedToTheWall)
{
    wallSurface surface(merge(duct(1), translated(cube(1), vector(0, 5, 0))));
    const label nDuct = duct(1).faces.size();
    surface.patchNames.append("loose");
    for (label facei = nDuct; facei < surface.faces.size(); ++facei)
    {
        surface.patchIDs[facei] = surface.patchNames.size() - 1;
    }
    const labelList sectors(surface.faces.size(), Zero);
    const layerControls layers(withoutLayers({"inlet", "loose"}));
    const bitSet joined(sideFaces(surface, sectors, layers).joinedToWall());

    forAll(surface.faces, facei)
    {
        EXPECT_EQ(joined.test(facei), facei < nDuct);
    }
}


// ************************************************************************* //
