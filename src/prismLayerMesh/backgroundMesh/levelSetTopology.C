/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "levelSetTopology.H"
#include "disjointSets.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Edges of a tetrahedron that the level set crosses, around the polygon that
//  it cuts out; seen from the lower side counter-clockwise
static label crossedEdges
(
    const tetCell& tet,
    const scalarField& field,
    const scalar level,
    FixedList<label, 4>& crossed
)
{
    // Points above first; their parity decides the orientation
    FixedList<label, 4> order({0, 1, 2, 3});
    const label nAbove = std::stable_partition
    (
        order.begin(), order.end(),
        [&](const label i) { return field[tet[i]] > level; }
    ) - order.begin();

    bool odd = false;
    for (label i = 0; i < 4; ++i)
    {
        for (label j = i + 1; j < 4; ++j)
        {
            odd = odd != (order[i] > order[j]);
        }
    }

    static const label ids[4][4] =
        {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};

    auto id = [&](label i, label j) { return ids[order[i]][order[j]]; };

    label n = 0;
    if (nAbove == 1)
    {
        for (label j = 1; j < 4; ++j) crossed[n++] = id(0, j);
    }
    else if (nAbove == 3)
    {
        for (label j = 0; j < 3; ++j) crossed[n++] = id(j, 3);
    }
    else if (nAbove == 2)
    {
        crossed[n++] = id(0, 2);
        crossed[n++] = id(0, 3);
        crossed[n++] = id(1, 3);
        crossed[n++] = id(1, 2);
    }

    if (odd)
    {
        std::reverse(crossed.begin(), crossed.begin() + n);
    }

    return n;
}


//- Whether the level set crosses the face of a tetrahedron opposite to point i
static bool isCrossed
(
    const tetCell& tet,
    const label i,
    const scalarField& field,
    const scalar level
)
{
    label nAbove = 0;
    for (label k = 1; k < 4; ++k)
    {
        nAbove += field[tet[(i + k) % 4]] > level;
    }

    return nAbove == 1 || nAbove == 2;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

surfaceTopology wallTopology
(
    const wallSurface& wall,
    const wallAddressing& addressing
)
{
    disjointSets components
    (
        connectedPoints(wall.points.size(), addressing.edges)
    );

    surfaceTopology topology;
    forAll(wall.points, p)
    {
        topology.nComponents += components.find(p) == p;
    }
    topology.eulerCharacteristic = wall.points.size()
      - addressing.edges.size() + wall.faces.size();

    return topology;
}


surfaceTopology levelSetTopology
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const scalar level
)
{
    disjointSets components(mesh.edges.size());
    boolList crossedEdge(mesh.edges.size(), false);
    label nPolygons = 0, nSides = 0;

    forAll(mesh.tets, t)
    {
        FixedList<label, 4> crossed;
        const label n = crossedEdges(mesh.tets[t], field, level, crossed);

        nPolygons += n > 0;
        nSides += n;

        // On the boundary of the mesh a side is of one polygon
        for (label i = 0; n && i < 4; ++i)
        {
            nSides += mesh.neighbours[t][i] < 0
                && isCrossed(mesh.tets[t], i, field, level);
        }

        for (label i = 0; i < n; ++i)
        {
            const label e = mesh.tetEdges[t][crossed[i]];
            crossedEdge[e] = true;
            components.join(e, mesh.tetEdges[t][crossed[0]]);
        }
    }

    label nPoints = 0;
    surfaceTopology topology;

    forAll(crossedEdge, e)
    {
        nPoints += crossedEdge[e];
        topology.nComponents += crossedEdge[e] && components.find(e) == e;
    }

    // Each side of a polygon is counted twice
    topology.eulerCharacteristic = nPoints - nSides/2 + nPolygons;

    return topology;
}


surfaceTopology wallLevelSetTopology(const backgroundMesh& mesh)
{
    return levelSetTopology(mesh, mesh.wallIndicator(), 0.5);
}


void levelSetTriangles
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const scalar level,
    pointField& points,
    faceList& triangles
)
{
    labelList edgePoint(mesh.edges.size(), -1);
    DynamicList<point> newPoints;
    DynamicList<face> newTriangles;
    forAll(mesh.tets, t)
    {
        FixedList<label, 4> crossed;
        const label n = crossedEdges(mesh.tets[t], field, level, crossed);

        for (label i = 0; i < n; ++i)
        {
            const label e = mesh.tetEdges[t][crossed[i]];

            if (edgePoint[e] < 0)
            {
                const label a = mesh.edges[e].start();
                const label b = mesh.edges[e].end();
                const scalar s = (level - field[a])/(field[b] - field[a]);

                edgePoint[e] = newPoints.size();
                newPoints.append((1 - s)*mesh.points[a] + s*mesh.points[b]);
            }
            crossed[i] = edgePoint[e];
        }

        for (label i = 2; i < n; ++i)
        {
            newTriangles.append(face({crossed[0], crossed[i-1], crossed[i]}));
        }
    }

    points.transfer(newPoints);
    triangles.transfer(newTriangles);
}

} // End namespace Foam

// ************************************************************************* //
