/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitGains.H"
#include "memoryMesh.H"
#include "testLayers.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const scalarList layerHeights({0, 0.01, 0.03, 0.07});


static finiteVolumes volumesOf(const polyMesh& mesh)
{
    return finiteVolumes
    {
        mesh.faceOwner(), mesh.faceNeighbour(), mesh.cells(),
        mesh.faceAreas(), mesh.faceCentres(), mesh.cellCentres(),
        mesh.cellVolumes()
    };
}


//- Gradients by Gauss of the field that is 1 in one cell, and 0 in others
static vectorField gradientsOfOne(const polyMesh& mesh, const label one)
{
    vectorField gradients(mesh.nCells(), Zero);
    forAll(mesh.faceNeighbour(), facei)
    {
        const label own = mesh.faceOwner()[facei];
        const label other = mesh.faceNeighbour()[facei];
        const vector& area = mesh.faceAreas()[facei];
        const point& centre = mesh.faceCentres()[facei];
        const scalar toOwn = mag(area & (centre - mesh.cellCentres()[own]));
        const scalar toOther = mag(area & (centre - mesh.cellCentres()[other]));
        const scalar share = toOther/(toOwn + toOther);
        const scalar value = own == one ? share : other == one ? 1 - share : 0;
        gradients[own] += value*area/mesh.cellVolumes()[own];
        gradients[other] -= value*area/mesh.cellVolumes()[other];
    }

    return gradients;
}


//- The gains from the definition: a column of the explicit matrix is the
//  corrections that the field of one cell makes
static scalarField gainsByColumns(const polyMesh& mesh)
{
    scalarField sums(mesh.nCells(), Zero);
    scalarField diagonal(mesh.nCells(), Zero);

    for (label one = 0; one < mesh.nCells(); ++one)
    {
        const vectorField gradients(gradientsOfOne(mesh, one));
        scalarField column(mesh.nCells(), Zero);
        forAll(mesh.faceNeighbour(), facei)
        {
            const label own = mesh.faceOwner()[facei];
            const label other = mesh.faceNeighbour()[facei];
            const vector& area = mesh.faceAreas()[facei];
            const point& centre = mesh.faceCentres()[facei];
            const vector d(mesh.cellCentres()[other] - mesh.cellCentres()[own]);
            const scalar along = (area & d)/mag(area);
            const scalar toOwn = mag(area & (centre - mesh.cellCentres()[own]));
            const scalar toOther =
                mag(area & (centre - mesh.cellCentres()[other]));
            const scalar share = toOther/(toOwn + toOther);
            const vector gradient
            (
                share*gradients[own] + (1 - share)*gradients[other]
            );
            const scalar flux = (area - mag(area)*d/along) & gradient;
            column[own] += flux;
            column[other] -= flux;
            if (one == 0)
            {
                diagonal[own] += mag(area)/along;
                diagonal[other] += mag(area)/along;
            }
        }
        sums += mag(column);
    }

    for (label f = mesh.nInternalFaces(); f < mesh.nFaces(); ++f)
    {
        const label own = mesh.faceOwner()[f];
        const vector& area = mesh.faceAreas()[f];
        diagonal[own] += magSqr(area)
           /(area & (mesh.faceCentres()[f] - mesh.cellCentres()[own]));
    }

    return sums/diagonal;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(explicitGains, areZeroOnAStackOfOrthogonalCells)
{
    const memoryMesh mesh(testSurfaces::onePolygon(4, layerHeights));

    for (const scalar gain : explicitGains(volumesOf(mesh())))
    {
        EXPECT_LT(gain, 1e-12);
    }
}


TEST(explicitGains, areNearToTheRowsOfTheMatricesOfTheScheme)
{
    for (const wallSurface& wall :
        {testSurfaces::cube(2), testSurfaces::sphere(2)})
    {
        const memoryMesh mesh(testSurfaces::straightLayers(wall, layerHeights));
        const scalarField rows(gainsByColumns(mesh()));
        const scalarField gains(explicitGains(volumesOf(mesh())));

        ASSERT_GT(max(rows), 0.001);
        forAll(gains, celli)
        {
            EXPECT_NEAR(gains[celli], rows[celli], 0.25*max(rows));
        }
    }
}


TEST(explicitGains, nameCellsOnWhichNoSchemeWorks)
{
    const memoryMesh mesh(testSurfaces::onePolygon(4, layerHeights));
    pointField centres(mesh().cellCentres());
    centres[1] = centres[0];
    const finiteVolumes good(volumesOf(mesh()));
    const scalarField gains
    (
        explicitGains
        (
            finiteVolumes
            {
                good.owner, good.neighbour, good.cells, good.faceAreas,
                good.faceCentres, centres, good.cellVolumes
            }
        )
    );

    EXPECT_LT(gains[0], invalidGain);
    EXPECT_EQ(gains[1], invalidGain);
}


// ************************************************************************* //
