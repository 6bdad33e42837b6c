/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nestedBodies.H"
#include "labelledTriangle.H"
#include "markedGrid.H"
#include "prismQuality.H"
#include "sideCrossings.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Triangles of one level of a front face: 0 the wall, else the outer surface.
//  Those that are degenerate are left out; true when there are such.
static bool addTriangles
(
    const prismLayers& layers,
    const label facei,
    const label level,
    std::vector<labelledTriangle>& triangles
)
{
    bool degenerate = false;
    const face& f = layers.faces[facei];

    for (label k = 1; k + 1 < f.size(); ++k)
    {
        labelledTriangle t;
        t.facei = facei + (level ? layers.faces.size() : 0);

        const label columns[3] = {f[0], f[k], f[k + 1]};

        for (int j = 0; j < 3; ++j)
        {
            t.labels[j] = layers.pointLabel(columns[j], level);
            t.points[j] = layers(columns[j], level);
        }

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


static boundBox boxOf
(
    const prismLayers& layers,
    const face& f,
    const label level
)
{
    boundBox box(boundBox::invertedBox);
    for (const label c : f)
    {
        box.add(layers(c, level));
    }

    return box;
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
        boxes.push_back(boxOf(layers, layers.faces[facei], layers.nLayers));
    }

    return boxes;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<labelPair> findIntersections(const prismLayers& layers)
{
    return findIntersections(layers, identity(layers.faces.size()));
}


List<labelPair> findOverlaps
(
    const prismLayers& layers,
    const labelUList& outerFaces,
    const layerBodies& bodies
)
{
    if (outerFaces.empty())
    {
        return List<labelPair>();
    }

    List<labelPair> pairs(findIntersections(layers, outerFaces));

    for (const label facei : findSideCrossings(layers, outerFaces))
    {
        const label outer = layers.faces.size() + facei;
        pairs.append(labelPair(outer, outer));
    }
    pairs.append(findNestedBodies(layers, outerFaces, bodies));

    return pairs;
}


List<labelPair> findIntersections
(
    const prismLayers& layers,
    const labelUList& outerFaces
)
{
    DynamicList<labelPair> pairs;
    boolList candidates(layers.faces.size(), false);
    UIndirectList<bool>(candidates, outerFaces) = true;

    // Each pair has one of the first
    std::vector<labelledTriangle> first, second;
    forAll(candidates, facei)
    {
        if
        (
            candidates[facei]
         && addTriangles(layers, facei, layers.nLayers, first)
        )
        {
            const label outerFace = layers.faces.size() + facei;
            pairs.append(labelPair(outerFace, outerFace));
        }
    }

    const markedGrid grid(boxesOf(layers, outerFaces));
    List<FixedList<bool, 2>> near(layers.faces.size());

    #pragma omp parallel for schedule(static, 1024)
    forAll(near, facei)
    {
        const face& f = layers.faces[facei];
        near[facei][0] = grid.mayTouch(boxOf(layers, f, 0));
        near[facei][1] = !candidates[facei]
            && grid.mayTouch(boxOf(layers, f, layers.nLayers));
    }

    forAll(near, facei)
    {
        // Where the wall is degenerate it is nothing its neighbours are not
        for (const label side : {1, 0})
        {
            if (near[facei][side])
            {
                addTriangles(layers, facei, side*layers.nLayers, second);
            }
        }
    }

    addIntersections(first, second, pairs);

    return List<labelPair>(std::move(pairs));
}

} // End namespace Foam

// ************************************************************************* //
