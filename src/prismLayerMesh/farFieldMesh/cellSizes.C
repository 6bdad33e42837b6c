/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "cellSizes.H"
#include "indexedOctree.H"
#include "treeBoundBox.H"
#include "treeDataPoint.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Width of a cube over the size in its centre, at most
static const scalar maxWidth = 1;


//- Centre of one of the eight parts of a cube, octant as of treeBoundBox
static point partCentre
(
    const point& centre,
    const scalar width,
    const label octant
)
{
    point c(centre);

    for (direction d = 0; d < 3; ++d)
    {
        c[d] += (octant >> d & 1 ? 0.25 : -0.25)*width;
    }

    return c;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellSizes::cellSizes
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
    width_(1.001*cmptMax(box.span())),
    cubes_(1, cube{-1, -1, GREAT})
{
    corner_ = box.midpoint() - point::uniform(0.5*width_);

    boundBox around(points_, false);
    around.add(box);
    around.inflate(0.01);
    const indexedOctree<treeDataPoint> tree
    (
        treeDataPoint(points_), treeBoundBox(around), 8, 10, 3
    );

    // One generation of cubes after the other
    pointField centres(1, box.midpoint());
    scalar width = width_;

    for (label first = 0; first < cubes_.size(); width /= 2)
    {
        const scalarField limits(bounds(centres));
        const label end = cubes_.size();
        DynamicList<point> parts;

        for (label cubei = first; cubei < end; ++cubei)
        {
            cube& c = cubes_[cubei];
            const point& centre = centres[cubei - first];
            c.source = tree.findNearest(centre, sqr(GREAT)).index();
            c.bound = limits[cubei - first];

            complete_ = complete_ && end + parts.size() <= maxCubes;

            if (complete_ && width > maxWidth*sizeAt(c, centre))
            {
                c.children = end + parts.size();

                for (label octant = 0; octant < 8; ++octant)
                {
                    parts.append(partCentre(centre, width, octant));
                }
            }
        }

        first = end;
        cubes_.append(List<cube>(parts.size(), cube{-1, -1, GREAT}));
        centres.transfer(parts);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Visit>
void Foam::cellSizes::forLeaves
(
    const label cubei,
    const point& centre,
    const scalar width,
    const Visit& visit
) const
{
    const cube& c = cubes_[cubei];

    if (c.children < 0)
    {
        visit(centre, width, sizeAt(c, centre));
        return;
    }

    for (label octant = 0; octant < 8; ++octant)
    {
        forLeaves
        (
            c.children + octant, partCentre(centre, width, octant), width/2,
            visit
        );
    }
}


Foam::scalar Foam::cellSizes::operator()(const point& x) const
{
    label cubei = 0;
    point centre(corner_ + point::uniform(0.5*width_));
    scalar width = width_;

    for (; cubes_[cubei].children >= 0; width /= 2)
    {
        const label octant =
            (x.x() > centre.x()) | (x.y() > centre.y()) << 1
          | (x.z() > centre.z()) << 2;

        centre = partCentre(centre, width, octant);
        cubei = cubes_[cubei].children + octant;
    }

    return sizeAt(cubes_[cubei], x);
}


Foam::scalar Foam::cellSizes::nCubes
(
    const std::function<bool(const point&)>& inside
) const
{
    scalar n = 0;

    forLeaves
    (
        0, corner_ + point::uniform(0.5*width_), width_,
        [&](const point& centre, const scalar width, const scalar size)
        {
            n += inside(centre) ? pow3(width/size) : 0;
        }
    );

    return n;
}


// ************************************************************************* //
