/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerPolygons.H"

#include "prismFaces.H"
#include "prismQuality.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A cell on a square whose corners are above and below it
static prismLayers warpedCell(const scalar warp, const scalar height)
{
    prismLayers layers;
    layers.nLayers = 1;
    layers.isCut = true;
    for (label k = 0; k < 4; ++k)
    {
        const point x(k == 1 || k == 2, k > 1, k % 2 ? warp : -warp);
        layers.points.append(x);
        layers.points.append(x + vector(0, 0, height));
    }
    layers.faces = faceList({face({0, 1, 2, 3})});
    layers.patchIDs = labelList(1, Zero);
    layers.patchNames = wordList(1, "wall");

    return layers;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(appendOuterFaces, aFaceThatStaysIsCutAsTheLayersAre)
{
    for (const scalar height : {0.1, 1e-3})
    {
        const prismLayers layers(warpedCell(0.01, height));
        const polygonControls controls;
        groupExceptions whole;
        whole.whole.set(0);
        const frontGroups front
        (
            groupFront(layers, findFaceNeighbours(layers), controls, whole)
        );
        ASSERT_EQ(front.nGroups, 1);

        const farFieldMesh none;
        const farTets tets(none, 0);
        const commonTriangles common;
        const cornerPoints points(layers, none, tets, common, controls);
        meshBuilder faces;
        appendOuterFaces(layers, front, points, 1, placesInMesh(), faces);
        labelList labels;
        const polyMeshParts mesh
        (
            makePolygonParts
            (
                faces, points, stayingPoints(faces, points), bitSet(1, true), 2,
                labels
            )
        );
        ASSERT_EQ(mesh.topology.faces.size(), 1);
        const label first = labels[mesh.topology.faces[0][0]];
        EXPECT_EQ(points.columnOf(first), outerFan(layers, 0)[0]);
        EXPECT_EQ(points.columnOf(first) % 2, height < 0.01 ? 1 : 0);
    }
}


// ************************************************************************* //
