/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readLocalHeights.H"
#include "surfaceFiles.H"
#include "thrownMessage.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A cube, and files with values for it
class readLocalHeightsFiles
:
    public surfaceFiles
{
protected:

    const wallSurface wall_ = testSurfaces::cube(2);
    prismLayerControls controls_;
    string found_;


    //- A list in which point p of the wall has the value low + x*slope
    fileName values(const scalar low, const scalar slope)
    {
        std::ostringstream list;
        list << wall_.points.size() << "(";

        for (const point& x : wall_.points)
        {
            list << low + x.x()*slope << " ";
        }

        return file("values", list.str() + ")").name();
    }

    localHeights read(const wallSurface& wall)
    {
        controls_.surface.files =
            fileNameList(1, file("wall.obj", wall_).name());
        const autoPtr<Time> time(Time::New());

        return readLocalHeights
        (
            wall,
            controls_,
            [&](const fileName& name) { return folder_/name; },
            time(),
            found_
        );
    }
};

} // End namespace Foam

using namespace Foam;


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_F(readLocalHeightsFiles, areEmptyWithoutFilesAndRegions)
{
    const localHeights local(read(wall_));

    EXPECT_TRUE(local.inRegion.empty());
    EXPECT_TRUE(local.firstThickness.empty());
    EXPECT_TRUE(local.thickness.empty());
    EXPECT_EQ(found_, "0 regions, 0 fields");
}


TEST_F(readLocalHeightsFiles, valuesAreThoseOfTheFile)
{
    controls_.layers.thicknessField.file = values(0.5, 0.25);
    const localHeights local(read(wall_));

    EXPECT_TRUE(local.firstThickness.empty());
    ASSERT_EQ(local.thickness.size(), wall_.points.size());

    forAll(wall_.points, p)
    {
        EXPECT_NEAR(local.thickness[p], 0.5 + wall_.points[p].x()/4, 1e-12);
    }
    expectWords(found_, {"0 regions, 1 fields", "values", "0.5 to 0.75 m"});
}


TEST_F(readLocalHeightsFiles, regionsNameTheirPoints)
{
    layerRegion region;
    region.name = "half";
    region.geometry =
        dictionaryOf("type searchableBox; min (-1 -1 -1); max (0.25 2 2);");
    controls_.layers.regions.append(region);

    const localHeights local(read(wall_));
    ASSERT_EQ(local.inRegion.size(), 1);

    forAll(wall_.points, p)
    {
        EXPECT_EQ(local.inRegion[0][p], wall_.points[p].x() < 0.25);
    }

    // One of the six sides, of three by three points
    expectWords(found_, {"1 regions", "region half: 9 points of the wall"});
}


TEST_F(readLocalHeightsFiles, surfaceElsewhereIsRefused)
{
    controls_.layers.firstLayerField.file = values(0.5, 0);
    const auto message = [&](const scalar shift)
    {
        return thrownMessage<error>([&]()
        {
            read(testSurfaces::translated(wall_, vector(shift, 0, 0)));
        });
    };

    // The diagonal is sqrt(3)
    EXPECT_EQ(message(0.017), "");
    expectWords(message(0.018), {"values", "is 0.018 m away", "another body"});
}


TEST_F(readLocalHeightsFiles, valuesThatAreNotHeightsAreRefused)
{
    controls_.layers.firstLayerField.file = values(0.5, -1);

    expectWords
    (
        thrownMessage<error>([&]() { read(wall_); }),
        {"values", "is -0.5", "from 1e-12 to 1e+06"}
    );
}


// ************************************************************************* //
