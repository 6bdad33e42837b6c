/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitGains.H"
#include "memoryMesh.H"
#include "testLayers.H"
#include "testSurfaces.H"

#include <Eigen/Dense>
#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static const scalarList layerHeights({0, 0.01, 0.03, 0.07});


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


//- The implicit and the explicit matrix of the scheme, from the definition
struct schemeMatrices
{
    Eigen::MatrixXd implicit;
    Eigen::MatrixXd explicitly;

    explicit schemeMatrices(const polyMesh& mesh)
    :
        implicit(Eigen::MatrixXd::Zero(mesh.nCells(), mesh.nCells())),
        explicitly(implicit)
    {
        // A column of the explicit matrix is the corrections that the field
        // of one cell makes
        for (label one = 0; one < mesh.nCells(); ++one)
        {
            addCorrections(mesh, gradientsOfOne(mesh, one), one);
        }
        addImplicit(mesh);
    }

    void addCorrections
    (
        const polyMesh& mesh,
        const vectorField& gradients,
        const label one
    )
    {
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
            explicitly(own, one) += flux;
            explicitly(other, one) -= flux;
        }
    }

    void addImplicit(const polyMesh& mesh)
    {
        forAll(mesh.faces(), f)
        {
            const label own = mesh.faceOwner()[f];
            const bool isInside = f < mesh.nInternalFaces();
            const label other = isInside ? mesh.faceNeighbour()[f] : own;
            const point& end =
                isInside ? mesh.cellCentres()[other] : mesh.faceCentres()[f];
            const vector& area = mesh.faceAreas()[f];
            const scalar coefficient =
                magSqr(area)/(area & (end - mesh.cellCentres()[own]));
            implicit(own, own) += coefficient;
            if (isInside)
            {
                implicit(other, other) += coefficient;
                implicit(own, other) -= coefficient;
                implicit(other, own) -= coefficient;
            }
        }
    }

    //- Sum of the magnitudes of each explicit row over the implicit diagonal
    Eigen::VectorXd gains() const
    {
        return explicitly.cwiseAbs().rowwise().sum().cwiseQuotient
        (
            implicit.diagonal()
        );
    }

    //- The largest magnitude of an eigenvalue of an iteration
    scalar factor() const
    {
        return implicit.ldlt().solve(explicitly).eigenvalues()
            .cwiseAbs().maxCoeff();
    }
};


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(leastSquaresGain, isLargeIfTheNeighboursAreNearlyInAPlane)
{
    // A cell with four neighbours whose faces are not orthogonal
    const auto gainAt = [](const scalar height)
    {
        const point own(Zero);
        const pointField others
        ({
            {1, 0, height}, {-1, 0, height}, {0, 1, -height}, {0, -1, -height}
        });
        DynamicList<schemeFace> faces;
        for (const point& x : others)
        {
            faces.append
            (
                seenFace(normalised(x) + vector(0, 0, 0.2), 0.5*x, own, &x)
            );
        }

        return leastSquaresGain(faces);
    };

    EXPECT_LT(gainAt(0.7), 1);
    EXPECT_GT(gainAt(0.01), 5*gainAt(0.1));
    EXPECT_EQ(gainAt(0), invalidGain);
}


TEST(leastSquaresGain, isZeroInACube)
{
    DynamicList<schemeFace> faces;
    for (label k = 0; k < 6; ++k)
    {
        vector normal(Zero);
        normal[k/2] = k % 2 ? 1 : -1;
        const point other(normal);
        faces.append(seenFace(normal, 0.5*normal, point::zero, &other));
    }
    EXPECT_NEAR(leastSquaresGain(faces), 0, 1e-14);
}


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
        const Eigen::VectorXd rows(schemeMatrices(mesh()).gains());
        const scalarField gains(explicitGains(volumesOf(mesh())));

        ASSERT_GT(rows.maxCoeff(), 0.001);
        forAll(gains, celli)
        {
            EXPECT_NEAR(gains[celli], rows[celli], 0.25*rows.maxCoeff());
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


TEST(localScheme, factorOnAllCellsIsThatOfTheMatrices)
{
    for (const wallSurface& wall :
        {testSurfaces::cube(2), testSurfaces::sphere(2)})
    {
        const memoryMesh mesh(testSurfaces::straightLayers(wall, layerHeights));
        const schemeMode mode
        (
            slowestModeOn(volumesOf(mesh()), identity(mesh().nCells()))
        );
        const scalar factor = schemeMatrices(mesh()).factor();

        ASSERT_GT(factor, 1e-4);
        EXPECT_NEAR(mode.factor, factor, 0.1*factor);
        EXPECT_NEAR(sumSqr(mode.values), 1, 1e-9);
    }
}


TEST(localScheme, cellsAroundAreThoseAcrossFaces)
{
    const memoryMesh mesh(testSurfaces::onePolygon(4, layerHeights));
    const finiteVolumes cells(volumesOf(mesh()));

    EXPECT_EQ(cellsAround(cells, labelList({0}), 0).size(), 1);
    EXPECT_EQ(cellsAround(cells, labelList({0}), 1).size(), 2);
    EXPECT_EQ(cellsAround(cells, labelList({0}), 5).size(), 3);
}


TEST(schemeGrade, isOfTheCellsWithLargeGains)
{
    const memoryMesh mesh
    (
        testSurfaces::straightLayers(testSurfaces::sphere(2), layerHeights)
    );
    const finiteVolumes cells(volumesOf(mesh()));
    scalarField gains(mesh().nCells(), 0);
    EXPECT_EQ(gradeOf(cells, gains).nLargeGains, 0);
    EXPECT_EQ(gradeOf(cells, gains).factor, 0);

    gains[3] = 1;
    const schemeGrade grade(gradeOf(cells, gains));
    EXPECT_EQ(grade.nLargeGains, 1);
    EXPECT_GT(grade.factor, 0);
    EXPECT_LE(grade.factor, 1.1*schemeMatrices(mesh()).factor());
}


// ************************************************************************* //
