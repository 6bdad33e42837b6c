/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "limitHeightJumps.H"
#include "EdgeMap.H"
#include "heightSeries.H"
#include "invertCompact.H"
#include "layerGeometry.H"
#include "ListOps.H"
#include "stageProgress.H"

#include <algorithm>
#include <functional>

namespace Foam
{

namespace
{

class heightSweeps
{
    const heightLimits& given_;
    const layerMoveControls& controls_;
    const columnTeam& team_;

    //- Faces of each column, and indices of the pairs of neighbours with each
    //  face
    const CompactListList<label> columnFaces_;
    const CompactListList<label> facePairs_;

    scalarField factors_;
    scalarField faceHeights_;

    //- The factors that each face asks of its columns
    CompactListList<scalar> asked_;

    scalar height(const label facei, const label k) const
    {
        return given_.heights[facei][k]*factors_[given_.faces[facei][k]];
    }

    void setFaceHeight(const label facei)
    {
        const label m = given_.faces[facei].size();
        faceHeights_[facei] = 0;

        for (label k = 0; k < m; ++k)
        {
            faceHeights_[facei] += height(facei, k)/m;
        }
    }

    //- Ask for lower ones of the tallest columns of a face that is too high
    void askTallest(const label facei)
    {
        const label m = given_.faces[facei].size();
        const scalar sum = m*given_.largest[facei];

        // The level to which they come down: one after the other passes it
        scalar level = given_.largest[facei];

        for (label pass = 0; pass < m; ++pass)
        {
            scalar below = 0;
            label nAbove = 0;

            for (label k = 0; k < m; ++k)
            {
                const scalar h = height(facei, k);
                below += h <= level ? h : 0;
                nAbove += h > level;
            }

            level = nAbove ? (sum - below)/nAbove : level;
        }

        for (label k = 0; k < m; ++k)
        {
            scalar& asked = asked_[facei][k];
            asked = min(asked, level/given_.heights[facei][k]);
        }
    }

    //- Ask for lower ones of the columns of a face that another face does not
    //  have
    void askBeside(const label facei, const label other)
    {
        const face& f = given_.faces[facei];
        const scalar bound = controls_.maxHeightJump*faceHeights_[other];
        scalar shared = 0, own = 0;
        label nOwn = 0;

        forAll(f, k)
        {
            const bool isShared = given_.faces[other].found(f[k]);
            (isShared ? shared : own) += height(facei, k);
            nOwn += !isShared;
        }

        // Not so low that they would be the low ones
        const scalar lowered = max
        (
            f.size()*bound - shared,
            nOwn*controls_.leastOverNeighbour*faceHeights_[other]
        );

        forAll(f, k)
        {
            if (!given_.faces[other].found(f[k]))
            {
                const scalar factor = factors_[f[k]]*lowered/max(own, VSMALL);
                scalar& asked = asked_[facei][k];
                asked = min(asked, max(factor, controls_.leastForJump));
            }
        }
    }

    //- Ask what a face needs by the heights as they are
    void ask(const label facei)
    {
        UList<scalar> asked(asked_[facei]);
        asked = 1.0;
        const scalar height = faceHeights_[facei]/(1 + controls_.slack);

        if (height > given_.largest[facei])
        {
            askTallest(facei);
        }

        for (const label pairi : facePairs_[facei])
        {
            const labelPair& pair = given_.neighbours[pairi];
            const label other = pair.other(facei);

            if (height > controls_.maxHeightJump*faceHeights_[other])
            {
                askBeside(facei, other);
            }
        }
    }

    //- The least factor that faces ask of a column
    scalar leastAsked(const label c) const
    {
        scalar least = 1;
        for (const label facei : columnFaces_[c])
        {
            least = min(least, asked_[facei][given_.faces[facei].find(c)]);
        }

        return least;
    }

public:

    heightSweeps
    (
        const heightLimits& given,
        const layerMoveControls& controls,
        const columnTeam& team,
        const label nColumns
    )
    :
        given_(given),
        controls_(controls),
        team_(team),
        columnFaces_(invertCompact(nColumns, given.faces)),
        facePairs_(invertCompact(given.faces.size(), given.neighbours)),
        factors_(nColumns, 1.0),
        faceHeights_(given.faces.size()),
        asked_(given.heights)
    {}

    //- Each own column takes the least factor that its faces ask for. False if
    //  none asked.
    bool sweep()
    {
        bool any = false;

        #pragma omp parallel
        {
            #pragma omp for schedule(static, 256)
            forAll(given_.faces, facei)
            {
                setFaceHeight(facei);
            }

            #pragma omp for schedule(static, 256)
            forAll(given_.faces, facei)
            {
                ask(facei);
            }

            #pragma omp for schedule(static, 256) reduction(||: any)
            forAll(factors_, c)
            {
                const scalar least =
                    team_.isOwn(c) ? leastAsked(c) : factors_[c];
                any = any || least < factors_[c];
                factors_[c] = min(factors_[c], least);
            }
        }

        team_.columns.update(factors_);

        return team_.any(any);
    }

    const scalarField& factors() const
    {
        return factors_;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

CompactListList<scalar> heightLimits::valuesOfCorners(const UList<face>& faces)
{
    labelList sizes(faces.size());
    forAll(faces, facei)
    {
        sizes[facei] = faces[facei].size();
    }

    return CompactListList<scalar>(sizes);
}


scalarField heightLimits::factors
(
    const label nColumns,
    const layerMoveControls& controls,
    const columnTeam& team
) const
{
    heightSweeps sweeps(*this, controls, team, nColumns);

    repeatUntilStable
    (
        "limiting first heights", controls.maxSweeps,
        [&]() { return sweeps.sweep(); }
    );

    return sweeps.factors();
}


// * * * * * * * * * * * * *  Limit Height Jumps * * * * * * * * * * * * * * //

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
    first.faces.shallowCopy(SubList<face>(layers.faces, front.nWallFaces));
    first.heights = heightLimits::valuesOfCorners(first.faces);
    first.largest.setSize(front.nWallFaces, 0);
    first.neighbours = neighbours;

    #pragma omp parallel for schedule(static, 256)
    forAll(first.faces, facei)
    {
        stackHeights stack(layers);
        const face& f = first.faces[facei];
        const vector& n = normals[facei];
        UList<scalar> heights(first.heights[facei]);
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
            editor.front().wallPoints.size(), editor.controls(), editor.team()
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
