/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "movingColumns.H"
#include "stackHeights.H"
#include "EdgeMap.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- First height of a face over what is asked for, at most, and over that of a
//  neighbour
static const scalar maxExcess = 1.03;
static const scalar maxChange = 1.28;


//- Faces of the wall with a common edge
static List<labelPair> neighboursOnWall(const layerFront& front)
{
    EdgeMap<label> firstFaces;
    DynamicList<labelPair> neighbours(2*front.nWallFaces);

    for (label facei = 0; facei < front.nWallFaces; ++facei)
    {
        const face& f = front.surface.faces[facei];

        forAll(f, k)
        {
            const edge e
            (
                front.wallPoints[f[k]], front.wallPoints[f[f.fcIndex(k)]]
            );
            const auto other = firstFaces.cfind(e);

            if (other.found())
            {
                neighbours.append(labelPair(other.val(), facei));
            }
            else
            {
                firstFaces.insert(e, facei);
            }
        }
    }

    return List<labelPair>(std::move(neighbours));
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::evenHeights Foam::movingColumns::firstHeights()
{
    const label nFaces = front_.nWallFaces;
    const pointField& wall = front_.surface.points;
    const vectorField normals(front_.surface.faceNormals());

    evenHeights first;
    first.faces = SubList<face>(layers_.faces, nFaces);
    first.heights.setSize(nFaces);
    first.largest.setSize(nFaces, 0);
    if (neighbours_.empty())
    {
        neighbours_ = neighboursOnWall(front_);
    }
    first.neighbours = neighbours_;
    first.maxChange = maxChange;

    stackHeights stack(layers_);

    forAll(first.faces, facei)
    {
        const face& f = first.faces[facei];
        const vector& n = normals[facei];
        scalarList& heights = first.heights[facei];
        heights.setSize(f.size());
        stack.compute(facei, 1);
        scalar mean = 0;

        forAll(f, k)
        {
            heights[k] = max((layers_(f[k], 1) - wall[f[k]]) & n, VSMALL);
            mean += heights[k]/f.size();
            first.largest[facei] +=
                maxExcess*spacing_.firstThickness[f[k]]/f.size();
        }

        // So that together they are what the cell has
        for (scalar& h : heights)
        {
            h *= stack.heights()[0]/mean;
        }
    }

    return first;
}


void Foam::movingColumns::lowerFirst(const label c, const scalar factor)
{
    const label n = spacing_.nLayers;
    const scalarList before(SubList<scalar>(heights_, n + 1, c*(n + 1)));
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

    // Along the column as it stands
    pointField points(n + 1);
    forAll(points, i)
    {
        points[i] = layers_(c, i);
    }

    label k = 1;
    for (label i = 1; i <= n; ++i)
    {
        while (k < n && before[k] < after[i])
        {
            ++k;
        }

        const scalar s = (after[i] - before[k - 1])/(before[k] - before[k - 1]);
        layers_.points[layers_.index(c, i)] =
            points[k - 1] + s*(points[k] - points[k - 1]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::movingColumns::even(const mover& moving)
{
    const scalarField factors
    (
        firstHeights().factors(front_.wallPoints.size())
    );
    bool any = false;

    forAll(factors, c)
    {
        if (factors[c] < 1)
        {
            any = true;
            moving(c);
            heightsOf(c);
            lowerFirst(c, factors[c]);

            if (columns_.causes[c] == squeezeCause::none)
            {
                columns_.causes[c] = squeezeCause::neighbour;
            }
            touch(c);
        }
    }

    return any;
}


// ************************************************************************* //
