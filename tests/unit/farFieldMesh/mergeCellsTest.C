/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitGains.H"
#include "ListOps.H"
#include "memoryMesh.H"
#include "mergeCells.H"
#include "soundMesh.H"
#include "testFarField.H"
#include "testStages.H"
#include "testSurfaces.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Thick layers in the concave edge of a block, with a far field
struct creaseCase
{
    prismLayerMesh run;
    farFieldControls controls;

    creaseCase()
    :
        run(testSurfaces::layeredMesh(testSurfaces::lBlock(6), 5, 0.4))
    {
        controls.type = farFieldType::tet;
        controls.boundary.type = farBoundaryType::box;
        controls.boundary.box =
            boundBox(point::uniform(-2), point::uniform(4));
    }

    farFieldMesh far(const bool polyhedra)
    {
        controls.polyhedra = polyhedra;

        return farFieldOf(run, controls);
    }
};


static scalar excessOf(const scalarField& gains)
{
    return sum(sqr(max(gains - mergeControls().gain, scalar(0))));
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(mergeCells, gainsOfTheWholeMeshFall)
{
    creaseCase c;
    const farFieldMesh tets(c.far(false));
    const farFieldMesh merged(c.far(true));
    ASSERT_LT(merged.nCells, tets.nCells);

    const memoryMesh before(c.run.made.layers, tets);
    const memoryMesh after(c.run.made.layers, merged);
    const scalarField gainsBefore(explicitGains(volumesOf(before())));
    const scalarField gainsAfter(explicitGains(volumesOf(after())));
    EXPECT_LE(max(gainsAfter), max(gainsBefore)*(1 + 1e-9));
    // Pairs alone leave 0.16 of it
    EXPECT_LT(excessOf(gainsAfter), 0.13*excessOf(gainsBefore));
}


TEST(mergeCells, theMeshIsSoundAndHasTheSameBoundary)
{
    creaseCase c;
    const farFieldMesh tets(c.far(false));
    const farFieldMesh merged(c.far(true));
    const memoryMesh memory(c.run.made.layers, merged);
    expectSound(memory());

    EXPECT_EQ(merged.topology.patchSizes, tets.topology.patchSizes);
    EXPECT_EQ(merged.frontFaces, tets.frontFaces);
    forAll(merged.topology.patchStarts, patchi)
    {
        const label start = merged.topology.patchStarts[patchi];
        const label startOfTets = tets.topology.patchStarts[patchi];
        for (label k = 0; k < merged.topology.patchSizes[patchi]; ++k)
        {
            ASSERT_EQ
            (
                merged.topology.faces[start + k],
                tets.topology.faces[startOfTets + k]
            );
        }
    }
    EXPECT_EQ(memory().cellZones()[1].size(), merged.nCells);
    EXPECT_NEAR
    (
        sum(memory().cellVolumes()),
        216 - testSurfaces::enclosedVolume(testSurfaces::lBlock(6)), 1e-9
    );
}


TEST(mergeCells, quadrilateralsAreWholeOrCut)
{
    creaseCase c;
    c.run = testSurfaces::layeredMesh(testSurfaces::quadSphere(4), 3, 0.1);
    const label nFaces = c.run.made.layers.faces.size();
    EXPECT_EQ(c.far(false).frontFaces.size(), 2*nFaces);

    const farFieldMesh merged(c.far(true));
    for (label k = 0; k < merged.frontFaces.size(); ++k)
    {
        const label front = merged.frontFaces[k];
        const bool isWhole =
            findIndices(merged.frontFaces, front).size() == 1;
        EXPECT_EQ
        (
            merged.topology.faces[merged.topology.patchStarts[0] + k].size(),
            isWhole ? 4 : 3
        );
    }
    EXPECT_LT(merged.frontFaces.size(), 1.2*nFaces);
}

// ************************************************************************* //
