/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "limitHeightJumps.H"
#include "EdgeMap.H"
#include "geometricHeights.H"
#include "heightLimits.H"
#include "stackHeights.H"

#include <algorithm>
#include <functional>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- First heights of the faces of the wall by their columns, and the limits
static heightLimits firstHeights
(
    const layerEditor& editor,
    const List<labelPair>& neighbours
)
{
    const layerFront& front = editor.front();
    const prismLayers& layers = editor.layers();
    const pointField& wall = front.surface.points;
    const vectorField normals(front.surface.faceNormals());

    heightLimits first;
    first.faces = SubList<face>(layers.faces, front.nWallFaces);
    first.heights.setSize(front.nWallFaces);
    first.largest.setSize(front.nWallFaces, 0);
    first.neighbours = neighbours;

    #pragma omp parallel for schedule(static, 256)
    forAll(first.faces, facei)
    {
        stackHeights stack(layers);
        const face& f = first.faces[facei];
        const vector& n = normals[facei];
        scalarList& heights = first.heights[facei];
        heights.setSize(f.size());
        stack.compute(facei, 1);
        scalar mean = 0;

        forAll(f, k)
        {
            heights[k] = max((layers(f[k], 1) - wall[f[k]]) & n, VSMALL);
            mean += heights[k]/f.size();
            first.largest[facei] += editor.controls().maxExcess
               *editor.spacing().firstThickness[f[k]]/f.size();
        }

        // So that together they are what the cell has
        for (scalar& h : heights)
        {
            h *= stack.heights()[0]/mean;
        }
    }

    return first;
}


//- Returns the heights [m] of the points of a column along the mean of its
//  normals
static scalarList heightsOf(const layerEditor& editor, const label c)
{
    scalarList heights(editor.spacing().nLayers + 1);
    const point root(editor.layers()(c, 0));
    forAll(heights, i)
    {
        heights[i] = editor.front().visibility.heightCosine
        (
            c, editor.layers()(c, i) - root
        );
    }

    return heights;
}


//- Whether each height is above the one before
static bool isAscending(const UList<scalar>& heights)
{
    return
        std::adjacent_find
        (
            heights.begin(), heights.end(), std::greater_equal<scalar>()
        )
     == heights.end();
}


//- Lower the first level of a column by a factor, along the column as it
//  stands; its last level stays.
//  before: the heights of its points, ascending
static void lowerFirst
(
    layerEditor& editor,
    const label c,
    const scalar factor,
    const UList<scalar>& before
)
{
    const label n = editor.spacing().nLayers;
    pointField points(n + 1);
    forAll(points, i)
    {
        points[i] = editor.layers()(c, i);
    }

    const scalar first = factor*before[1];
    scalarList after(n + 1, 0.0);
    after[1] = first;

    if (n > 1)
    {
        layerHeights
        (
            n, first, fittedRatio(n, first, before[n]), before[n], after
        );
    }

    label k = 1;
    for (label i = 1; i <= n; ++i)
    {
        while (k < n && before[k] < after[i])
        {
            ++k;
        }

        const scalar s = (after[i] - before[k - 1])/(before[k] - before[k - 1]);
        editor.setPoint(c, i, points[k - 1] + s*(points[k] - points[k - 1]));
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<labelPair> neighboursOnWall(const layerFront& front)
{
    const wallAddressing& addressing = front.addressing;
    const auto isOfWall = [&](const label facei)
    {
        return facei >= 0 && facei < front.nWallFaces;
    };
    EdgeMap<label> firstFaces;
    DynamicList<labelPair> neighbours(addressing.edges.size());

    forAll(addressing.edges, e)
    {
        const labelPair& two = addressing.edgeFaces[e];

        if (isOfWall(two.first()) && isOfWall(two.second()))
        {
            neighbours.append(two);
        }
        else if (isOfWall(two.first()) || isOfWall(two.second()))
        {
            // Between the two faces at the edge of the wall are others
            const label facei =
                isOfWall(two.first()) ? two.first() : two.second();
            const edge ofWall
            (
                front.wallPoints[addressing.edges[e].start()],
                front.wallPoints[addressing.edges[e].end()]
            );
            const auto other = firstFaces.cfind(ofWall);

            if (other.found())
            {
                neighbours.append(labelPair(other.val(), facei));
            }
            else
            {
                firstFaces.insert(ofWall, facei);
            }
        }
    }

    return List<labelPair>(std::move(neighbours));
}


bool limitHeightJumps(layerEditor& editor, const List<labelPair>& neighbours)
{
    const scalarField factors
    (
        firstHeights(editor, neighbours).factors
        (
            editor.front().wallPoints.size(), editor.controls(),
            editor.team()
        )
    );
    DynamicList<label> lowered;

    forAll(factors, c)
    {
        if (factors[c] >= 1 || !editor.mayMove(c))
        {
            continue;
        }

        // A column that bends back has no place for each height
        const scalarList before(heightsOf(editor, c));
        if (isAscending(before))
        {
            lowered.append(c);
            editor.remember(c);
            lowerFirst(editor, c, factors[c], before);

            if (editor.causes()[c] == squeezeCause::none)
            {
                editor.setCause(c, squeezeCause::neighbour);
            }
            editor.touch(c);
        }
    }

    editor.publish(lowered);

    return editor.team().any(lowered.size());
}

} // End namespace Foam

// ************************************************************************* //
