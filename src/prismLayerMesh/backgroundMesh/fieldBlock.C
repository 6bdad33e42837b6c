/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldBlock.H"
#include "ListOps.H"
#include "reachGrid.H"
#include "surfacePart.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- How far a block goes beyond its points [m]
static scalar reachOf
(
    const scalarField& radius,
    const labelUList& own,
    const blockControls& controls
)
{
    return controls.reach*max(scalarField(radius, own));
}


namespace
{

//- A cut of points across an axis
struct cut
{
    direction axis = 0;

    //- Number of points below the plane
    label nBelow = 0;

    //- Number of points that the larger part depends on
    label larger = labelMax;
};

} // End anonymous namespace


//- Places at which a cut is tried along each axis
static constexpr label nPlaces = 256;


//- The cut of which the larger part is smallest, with the points of the other
//  part in reach
static cut bestCut
(
    const pointField& points,
    const labelUList& part,
    const scalar reach
)
{
    const label n = part.size();
    const pointField own(points, part);
    cut best;
    for (direction d = 0; d < 3; ++d)
    {
        scalarField x(own.component(d));
        std::sort(x.begin(), x.end());
        for (label k = 1; k < nPlaces; ++k)
        {
            const label nBelow = label(scalar(n)*k/nPlaces);
            const auto upTo =
                std::upper_bound(x.begin(), x.end(), x[nBelow] + reach);
            const auto from =
                std::lower_bound(x.begin(), x.end(), x[nBelow] - reach);
            const label larger = max(upTo - x.begin(), x.end() - from);
            if (nBelow && larger < best.larger)
            {
                best = {d, nBelow, larger};
            }
        }
    }

    return best;
}


static void divide
(
    const pointField& points,
    const scalarField& radius,
    const blockControls& controls,
    labelList& part,
    DynamicList<labelList>& parts
)
{
    const label n = part.size();
    const cut at(bestCut(points, part, reachOf(radius, part, controls)));
    if (n <= controls.maxPoints || at.larger > controls.largestShare*n)
    {
        sort(part);
        parts.append(part);
        return;
    }

    std::nth_element
    (
        part.begin(),
        part.begin() + at.nBelow,
        part.end(),
        [&](const label p, const label q)
        {
            const scalar x = points[p][at.axis], y = points[q][at.axis];
            return x < y || (x == y && p < q);
        }
    );

    labelList first(SubList<label>(part, at.nBelow));
    labelList second(SubList<label>(part, n - at.nBelow, at.nBelow));
    divide(points, radius, controls, first, parts);
    divide(points, radius, controls, second, parts);
}


static std::vector<boundBox> boxesOfPoints
(
    const wallSurface& wall,
    const labelUList& points
)
{
    std::vector<boundBox> boxes;
    for (const label p : points)
    {
        boxes.push_back(boundBox(wall.points[p], wall.points[p]));
    }

    return boxes;
}


static std::vector<boundBox> boxesOfFaces
(
    const wallSurface& wall,
    const labelUList& faces
)
{
    std::vector<boundBox> boxes;
    for (const label facei : faces)
    {
        boxes.push_back(boundBox(wall.points, wall.faces[facei], false));
    }

    return boxes;
}


//- Returns the faces among some that are within the distance of a grid, and
//  further ones
static labelList facesNear
(
    const wallSurface& wall,
    const labelUList& faces,
    const reachGrid& grid
)
{
    return subsetList(faces, [&](const label facei)
    {
        return grid.mayReach
        (
            boundBox(wall.points, wall.faces[facei], false)
        );
    });
}


//- Returns the faces of the block, see makeFieldBlock
static labelList facesOfBlock
(
    const wallSurface& wall,
    const labelUList& own,
    const labelUList& needed,
    const scalar reach,
    const scalar margin
)
{
    const boundBox box(widened(boundBox(wall.points, own, false), reach));
    const labelList around
    (
        subsetList
        (
            needed,
            [&](const label p) { return box.contains(wall.points[p]); }
        )
    );

    return facesNear
    (
        wall,
        facesNear
        (
            wall, facesIn(wall, box),
            reachGrid(boxesOfPoints(wall, own), reach)
        ),
        reachGrid(boxesOfPoints(wall, around), margin)
    );
}


//- Sets what is whole, and the neighbours of points.
//  around: the addressing of the surroundings
//  nearPoints: labels in the surroundings of the points of the block
static void setNeighbours
(
    const wallAddressing& around,
    const labelUList& nearPoints,
    fieldBlock& block
)
{
    labelList nFaces(block.points.size(), 0);
    for (const face& f : block.wall.faces)
    {
        for (const label p : f)
        {
            ++nFaces[p];
        }
    }

    const labelList local(invert(around.pointFaces.size(), nearPoints));
    block.isWhole.setSize(nFaces.size());
    block.pointPoints.setSize(nFaces.size());
    forAll(block.points, p)
    {
        const label q = nearPoints[p];
        block.isWhole[p] = nFaces[p] == around.pointFaces[q].size();
        block.pointPoints[p] =
            UIndirectList<label>(local, around.pointPoints[q]);
        inplaceSubsetList
        (
            block.pointPoints[p], [](const label r) { return r >= 0; }
        );
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool hasBlocks
(
    const pointField& points,
    const scalarField& radius,
    const blockControls& controls
)
{
    return points.size() > controls.largeWall
        && cmptMax(boundBox(points, false).span())
        >= controls.largeWidth*controls.reach*max(radius);
}


labelListList divideWall
(
    const pointField& points,
    const scalarField& radius,
    const labelUList& some,
    const blockControls& controls
)
{
    DynamicList<labelList> parts;
    if (some.size())
    {
        labelList all(some);
        divide(points, radius, controls, all, parts);
    }

    return labelListList(std::move(parts));
}


fieldBlock makeFieldBlock
(
    const wallSurface& wall,
    const envelopeRadii& radii,
    const labelList& own,
    const labelUList& needed,
    const blockControls& controls,
    const backgroundMeshControls& mesh,
    const scalar maxStretch
)
{
    const scalar reach = reachOf(radii.radius, own, controls);
    const scalar margin = reach*controls.margin/controls.reach;
    const labelList inside(facesOfBlock(wall, own, needed, reach, margin));
    const boundBox box(widened(boxOfFaces(wall, inside), reach));
    const labelList around
    (
        facesNear
        (
            wall, facesIn(wall, box),
            reachGrid(boxesOfFaces(wall, inside), reach)
        )
    );
    bitSet others(pointsOf(faceList(wall.faces, inside), wall.points.size()));
    others.unset(own);

    fieldBlock block;
    block.points = own;
    block.points.append(others.toc());
    block.nOwn = own.size();
    block.wall = partOf(wall, block.points, inside);

    const surfacePart near(makeSurfacePart(wall, around));
    wallContext context(near.surface);
    const labelList nearPoints(near.localPoints(block.points));
    block.envelope = makeOffsetEnvelope
    (
        context, radii.at(near.points), nearPoints, mesh, maxStretch
    );
    setNeighbours(context.addressing, nearPoints, block);
    block.search = std::move(context.search);

    return block;
}

} // End namespace Foam

// ************************************************************************* //
