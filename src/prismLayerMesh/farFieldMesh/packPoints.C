/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "packPoints.H"
#include "farFieldMeshControls.H"
#include "ListOps.H"
#include "sparsePoints.H"
#include "wallSearch.H"

#include <cmath>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Where a cube is: not known yet, not in the space, at its surfaces, or in the
//  space and away from its surfaces
enum class cubePlace { unknown, outside, near, inside };

struct cube
{
    point centre;
    cubePlace place;
};


class cubeDivider
{
    const wallSearch& search_;
    const cellSizes& sizes_;

public:

    cubeDivider(const wallSearch& search, const cellSizes& sizes)
    :
        search_(search),
        sizes_(sizes)
    {}

    //- Finds the place of a cube. The parts of the cube have the same place.
    //  Returns the integral of 1/size^3 over the cube if the cube counts as a
    //  whole as in the space, as its centre is, otherwise 0.
    //  size: at the centre
    scalar judge(const scalar width, const scalar size, cube& c) const
    {
        if
        (
            c.place != cubePlace::unknown
         || width > farFieldTuned.sideWidth*size
        )
        {
            return 0;
        }

        const scalar margin = farFieldTuned.packedMargin;
        const scalar toCorner = 0.5*std::sqrt(3.0)*width;
        const bool isInFront = search_.inFront(c.centre);
        c.place =
            search_.nearer
            (
                c.centre, margin*size + (1 + margin*sizes_.slope())*toCorner
            )
          ? cubePlace::near
          : isInFront ? cubePlace::inside : cubePlace::outside;

        return isInFront ? pow3(width/size) : 0;
    }
};

} // End anonymous namespace


//- Labels of sizes in ascending order. Sizes within a tenth count as equal and
//  stay in their order: cubes next to each other are then near to each other in
//  memory, too, and are packed in half of the time.
static labelList fromFineToCoarse(const UList<scalar>& sizes)
{
    labelList classes(sizes.size());
    forAll(classes, i)
    {
        classes[i] = std::floor(8*std::log2(sizes[i]));
    }

    return sortedOrder(classes);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

cubeCentres cubesBetween
(
    const pointField& points,
    const wallSearch& search,
    const cellSizes& sizes,
    const label maxPoints
)
{
    const boundBox box(points, false);
    const cubeDivider divider(search, sizes);
    cubeCentres made;

    // One generation of cubes after the other
    scalar width = farFieldTuned.cubeWidth*cmptMax(box.span());
    DynamicList<cube> cubes(1, cube{box.midpoint(), cubePlace::unknown});
    while (made.complete && cubes.size())
    {
        scalarField at(cubes.size()), inSizes(cubes.size());

        #pragma omp parallel for schedule(dynamic, 64)
        forAll(cubes, i)
        {
            at[i] = sizes(cubes[i].centre);
            inSizes[i] = divider.judge(width, at[i], cubes[i]);
        }

        DynamicList<cube> parts;
        forAll(cubes, i)
        {
            const cube& c = cubes[i];
            made.nCubes += inSizes[i];
            if (c.place == cubePlace::outside)
            {
                continue;
            }
            else if (width <= farFieldTuned.packedWidth*at[i])
            {
                made.points.append(c.centre);
                made.sizes.append(at[i]);
                made.areNear.append(c.place == cubePlace::near);
                continue;
            }
            for (label octant = 0; octant < 8; ++octant)
            {
                parts.append
                (
                    cube{partCentre(c.centre, width, octant), c.place}
                );
            }
        }
        cubes.transfer(parts);
        made.complete = made.points.size() + cubes.size() <= maxPoints;
        width /= 2;
    }

    return made;
}


pointField packPoints
(
    const pointField& points,
    const wallSearch& search,
    const cellSizes& sizes,
    const cubeCentres& centres
)
{
    const label n = points.size();
    pointField all(points);
    scalarField distances(n);
    forAll(distances, p)
    {
        distances[p] = sizes(all[p]);
    }
    const labelList order(fromFineToCoarse(centres.sizes));
    all.append(pointField(centres.points, order));
    distances.append(scalarField(centres.sizes, order));
    const labelList kept
    (
        sparsePoints(all, farFieldTuned.packedDistance*distances)
    );

    // At the surfaces points may be behind, or too near
    boolList stays(kept.size(), true);

    #pragma omp parallel for schedule(dynamic, 64)
    forAll(kept, i)
    {
        const label p = kept[i];
        const scalar margin = farFieldTuned.packedMargin*distances[p];
        if (p < n || centres.areNear[order[p - n]])
        {
            stays[i] =
                p >= n && !search.nearer(all[p], margin)
             && search.inFront(all[p]);
        }
    }

    DynamicList<point> packed(kept.size());
    forAll(kept, i)
    {
        if (stays[i])
        {
            packed.append(all[kept[i]]);
        }
    }

    return pointField(std::move(packed));
}

} // End namespace Foam

// ************************************************************************* //
