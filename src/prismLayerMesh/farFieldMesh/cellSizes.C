/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellSizes.H"
#include "farFieldMeshControls.H"
#include "regionSearch.H"
#include "searchTree.H"
#include "treeDataPoint.H"

#include <memory>

namespace Foam
{

point partCentre(const point& centre, const scalar width, const label octant)
{
    point c(centre);

    for (direction d = 0; d < 3; ++d)
    {
        c[d] += (octant >> d & 1 ? 0.25 : -0.25)*width;
    }

    return c;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

scalarField cellSizes::boundsAt
(
    const UList<place>& places,
    const sizeBounds& bounds
) const
{
    if (!bounds.atPoints)
    {
        return scalarField(places.size(), GREAT);
    }

    pointField centres(places.size());
    forAll(places, i)
    {
        centres[i] = places[i].centre;
    }

    return bounds.atPoints(centres);
}


void cellSizes::setSource
(
    const indexedOctree<treeDataPoint>& tree,
    const scalar width,
    const scalar bound,
    place& at
) const
{
    // Where the bound is smaller all over the cube, any point will do
    if (at.least - change(width) > bound + change(width))
    {
        return;
    }

    const scalar share = farFieldTuned.nearerShare;
    const scalar distance = mag(points_[at.source] - at.centre);
    const label nearer =
        tree.findNearest(at.centre, sqr((1 - share)*distance)).index();
    at.source = nearer < 0 ? at.source : nearer;
    at.least = fromPoint(at.source, at.centre)
      - slope_*share*mag(points_[at.source] - at.centre);
}


vector cellSizes::spanInBox(const point& centre, const scalar width) const
{
    const vector half(vector::uniform(0.5*width));

    return min(centre + half, box_.max()) - max(centre - half, box_.min());
}


scalar cellSizes::nEqualIn
(
    const point& centre,
    const scalar width,
    const scalar size
) const
{
    const vector span(spanInBox(centre, width)/size);

    return cmptMin(span) < 0 ? 0 : cmptProduct(max(span, vector::one));
}


bool cellSizes::isDivided
(
    const cube& c,
    const place& at,
    const scalar width,
    const scalar bound
) const
{
    return cmptMin(spanInBox(at.centre, width)) >= 0
     && min(bound, at.least) - change(width) < c.bound
     && width > farFieldTuned.maxWidth*sizeAt(c, at.centre);
}


void cellSizes::addParts
(
    const place& at,
    const scalar width,
    DynamicList<place>& parts
) const
{
    const scalar least = at.least - 0.5*change(width);

    for (label octant = 0; octant < 8; ++octant)
    {
        const point centre(partCentre(at.centre, width, octant));
        parts.append(place{centre, at.source, least});
    }
}


void cellSizes::divide
(
    const place& at,
    const scalar width,
    const scalar bound,
    const label maxCubes,
    cube& c,
    scalar& nEqual,
    DynamicList<place>& parts
)
{
    const bool divided = isDivided(c, at, width, bound);
    const label first = cubes_.size() + parts.size();
    nEqual += divided ? 0 : nEqualIn(at.centre, width, sizeAt(c, at.centre));
    complete_ = complete_ && first + nEqual <= maxCubes;

    if (complete_ && divided)
    {
        c.children = first;
        addParts(at, width, parts);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

cellSizes::cellSizes
(
    const pointField& points,
    const scalarField& sizes,
    const scalar ratio,
    const boundBox& box,
    const sizeBounds& bounds,
    const label maxCubes
)
:
    points_(points),
    sizes_(sizes),
    slope_(ratio - 1),
    box_(box),
    width_(farFieldTuned.cubeWidth*cmptMax(box.span())),
    cubes_(1, cube{-1, -1, GREAT})
{
    corner_ = box.midpoint() - point::uniform(0.5*width_);

    boundBox around(points_, false);
    around.add(box);
    const auto tree(makeSearchTree(treeDataPoint(points_), around, 0.01, 8));

    // One generation of cubes after the other
    const point& middle = box.midpoint();
    const label nearest = tree->findNearest(middle, sqr(GREAT)).index();
    DynamicList<place> places(1, place{middle, nearest, -GREAT});
    scalar width = width_;

    // Cubes that are left out where they would all have the same size
    scalar nEqual = 0;

    for (label first = 0; first < cubes_.size(); width /= 2)
    {
        const scalarField limits(boundsAt(places, bounds));

        #pragma omp parallel for schedule(dynamic, 64)
        forAll(places, i)
        {
            setSource(tree, width, limits[i], places[i]);
            cubes_[first + i].source = places[i].source;
            cubes_[first + i].bound = min(bounds.largest, limits[i]);
        }

        const label end = cubes_.size();
        DynamicList<place> parts;
        forAll(places, i)
        {
            divide
            (
                places[i], width, limits[i], maxCubes, cubes_[first + i],
                nEqual, parts
            );
        }

        first = end;
        cubes_.append(List<cube>(parts.size(), cube{-1, -1, GREAT}));
        places.transfer(parts);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar cellSizes::operator()(const point& x) const
{
    const point nearest(max(box_.min(), min(box_.max(), x)));
    label cubei = 0;
    point centre(corner_ + point::uniform(0.5*width_));
    scalar width = width_;

    for (; cubes_[cubei].children >= 0; width /= 2)
    {
        const label octant =
            (nearest.x() > centre.x()) | (nearest.y() > centre.y()) << 1
          | (nearest.z() > centre.z()) << 2;

        centre = partCentre(centre, width, octant);
        cubei = cubes_[cubei].children + octant;
    }

    return sizeAt(cubes_[cubei], x);
}


// * * * * * * * * * * * * * *  Make Size Bounds * * * * * * * * * * * * * * //

sizeBounds makeSizeBounds(const farFieldControls& controls, const Time& time)
{
    sizeBounds bounds;
    bounds.largest = controls.maxCellSize;
    if (controls.regions.empty())
    {
        return bounds;
    }

    const auto searches = std::make_shared<const PtrList<regionSearch>>
    (
        makeSearches(controls.regions, time)
    );

    bounds.atPoints = [=](const pointField& points)
    {
        scalarField sizes(points.size(), GREAT);

        forAll(*searches, i)
        {
            const scalarField distances((*searches)[i].distances(points));

            sizes = min
            (
                sizes,
                controls.regions[i].cellSize
              + (controls.growthRate - 1)*distances
            );
        }

        return sizes;
    };

    return bounds;
}

} // End namespace Foam

// ************************************************************************* //
