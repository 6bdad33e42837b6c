/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "markedGrid.H"
#include "prismQuality.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Adds the triangles of one level of a front face, but for those that are
//  degenerate. Returns whether there are such.
static bool addTriangles
(
    const prismLayers& layers,
    const label facei,
    const label level,
    const columnTeam& team,
    std::vector<labelledTriangle>& triangles
)
{
    bool degenerate = false;

    for
    (
        const labelledTriangle& t
      : trianglesOf(layers, facei, level, team)
    )
    {
        if (t.degenerate())
        {
            degenerate = true;
        }
        else
        {
            triangles.push_back(t);
        }
    }

    return degenerate;
}


//- Returns the bounding boxes of the outer faces of some front faces
static std::vector<boundBox> boxesOf
(
    const prismLayers& layers,
    const labelUList& faces
)
{
    std::vector<boundBox> boxes;
    boxes.reserve(faces.size());
    for (const label facei : faces)
    {
        boxes.push_back(boxOf(layers, facei, layers.nLayers));
    }

    return boxes;
}


//- Adds the triangles that a process counts, on both levels, in marked cells of
//  a grid, but for the outer ones of candidates
static void addNear
(
    const prismLayers& layers,
    const stackBoxes& groups,
    const boolList& candidates,
    const markedGrid& grid,
    const columnTeam& team,
    std::vector<labelledTriangle>& triangles
)
{
    List<FixedList<bool, 2>> near
    (
        layers.faces.size(), FixedList<bool, 2>(false)
    );

    #pragma omp parallel for schedule(dynamic, 8)
    forAll(groups.all(), group)
    {
        if (!grid.mayTouch(groups.all()[group]))
        {
            continue;
        }
        for (const label facei : groups.faces(group))
        {
            const bool counts = team.counts(layers.faces[facei]);
            near[facei][0] = counts && grid.mayTouch(boxOf(layers, facei, 0));
            near[facei][1] = counts && !candidates[facei]
             && grid.mayTouch(boxOf(layers, facei, layers.nLayers));
        }
    }

    forAll(near, facei)
    {
        // Where the wall is degenerate it is nothing its neighbours are not
        for (const label side : {1, 0})
        {
            if (near[facei][side])
            {
                addTriangles
                (
                    layers, facei, side*layers.nLayers, team, triangles
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<labelPair> findIntersections(const prismLayers& layers)
{
    return findIntersections(layers, identity(layers.faces.size()));
}


List<labelPair> findIntersections
(
    const prismLayers& layers,
    const labelUList& outerFaces
)
{
    return findIntersections
    (
        layers, outerFaces, stackBoxes(layers),
        std::vector<labelledTriangle>(), columnTeam::alone()
    );
}


std::vector<labelledTriangle> trianglesOf
(
    const prismLayers& layers,
    const label facei,
    const label level,
    const columnTeam& team
)
{
    std::vector<labelledTriangle> triangles;
    const face& f = layers.faces[facei];

    for (label k = 1; k + 1 < f.size(); ++k)
    {
        labelledTriangle t;
        t.facei = facei + (level ? layers.faces.size() : 0);

        const label columns[3] = {f[0], f[k], f[k + 1]};

        for (int j = 0; j < 3; ++j)
        {
            const label c = level ? columns[j] : layers.root(columns[j]);
            t.labels[j] = 2*team.wholeColumn(c) + (level > 0);
            t.points[j] = layers(columns[j], level);
        }
        triangles.push_back(t);
    }

    return triangles;
}


List<labelPair> findIntersections
(
    const prismLayers& layers,
    const labelUList& outerFaces,
    const stackBoxes& groups,
    const std::vector<labelledTriangle>& others,
    const columnTeam& team
)
{
    DynamicList<labelPair> pairs;
    boolList candidates(layers.faces.size(), false);
    UIndirectList<bool>(candidates, outerFaces) = true;

    // Each pair has one of the first
    std::vector<labelledTriangle> first(others), second;
    forAll(candidates, facei)
    {
        if
        (
            candidates[facei]
         && addTriangles(layers, facei, layers.nLayers, team, first)
        )
        {
            const label outerFace = layers.faces.size() + facei;
            pairs.append(labelPair(outerFace, outerFace));
        }
    }

    std::vector<boundBox> boxes(boxesOf(layers, outerFaces));
    for (const labelledTriangle& t : others)
    {
        boxes.push_back(t.box());
    }
    addNear(layers, groups, candidates, markedGrid(boxes), team, second);
    addIntersections(first, second, pairs);

    return List<labelPair>(std::move(pairs));
}

} // End namespace Foam

// ************************************************************************* //
