/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "expectedFarField.H"
#include "farFieldMeshControls.H"
#include "farFieldSizes.H"
#include "planarColumns.H"
#include "tetBoundary.H"
#include "wallSearch.H"

#include <cmath>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The space in front of closed surfaces, beyond the layers
class farSpace
{
    const wallSearch surfaces_;
    const wallSearch wall_;

    //- Of the layers above each point of the wall [m]
    const scalarField thickness_;

public:

    farSpace
    (
        const wallSurface& both,
        const wallSurface& wall,
        const pointField& outerPoints
    )
    :
        surfaces_(both),
        wall_(wall),
        thickness_(mag(outerPoints - wall.points))
    {}

    bool isBeyondLayers(const point& x) const
    {
        const wallSearch::foot foot(wall_.footOf(x));
        scalar thickness = 0;
        forAll(foot.points, k)
        {
            thickness += foot.weights[k]*thickness_[foot.points[k]];
        }

        return foot.distance > thickness;
    }

    bool has(const point& x) const
    {
        return surfaces_.inFront(x) && isBeyondLayers(x);
    }

    //- Whether the space may have a part of a cube
    bool mayHavePart(const point& centre, const scalar width) const
    {
        return surfaces_.nearer(centre, 0.5*std::sqrt(3.0)*width)
            || surfaces_.inFront(centre);
    }
};

} // End anonymous namespace


//- The integral of 1/size^3 over a space, by cubes that are no wider than the
//  size at their centres
static scalar nCubesIn
(
    const farSpace& space,
    const cellSizes& sizes,
    const boundBox& box
)
{
    scalar nCubes = 0;
    scalar width = farFieldTuned.cubeWidth*cmptMax(box.span());
    DynamicList<point> cubes(1, box.midpoint());
    for (; cubes.size(); width /= 2)
    {
        scalarField shares(cubes.size(), Zero);
        List<char> areDivided(cubes.size(), false);

        #pragma omp parallel for schedule(dynamic, 64)
        forAll(cubes, i)
        {
            const scalar size = sizes(cubes[i]);
            areDivided[i] =
                width > size && space.mayHavePart(cubes[i], width);
            if (width <= size && space.has(cubes[i]))
            {
                shares[i] = pow3(width/size);
            }
        }

        nCubes += sum(shares);
        DynamicList<point> parts;
        forAll(cubes, i)
        {
            for (label octant = 0; areDivided[i] && octant < 8; ++octant)
            {
                parts.append(partCentre(cubes[i], width, octant));
            }
        }
        cubes.transfer(parts);
    }

    return nCubes;
}


static wallSurface trianglesOf(const wallSurface& wall)
{
    labelList triangleFaces;
    wallSurface triangles(wall);
    triangles.faces = outerTriangles(wall, triangleFaces);
    triangles.patchIDs.setSize(triangles.faces.size(), 0);

    return triangles;
}


//- nCubes: see nCubesIn
static scalar cellsIn
(
    const farFieldType type,
    const scalar nCubes,
    const label nWallFaces
)
{
    return
        type == farFieldType::hexCore
      ? farFieldTuned.hexesPerCube*nCubes
      + farFieldTuned.tetsPerCoreFace*nWallFaces
      : farFieldTuned.tetsPerCube*nCubes;
}


//- The number of triangles on a patch that are beyond the layers
static scalar nTrianglesOn
(
    const word& patch,
    const wallSurface& boundary,
    const farSpace& space
)
{
    const label patchi = boundary.patchNames.find(patch);
    label n = 0;
    forAll(boundary.faces, i)
    {
        if
        (
            boundary.patchIDs[i] == patchi
         && space.isBeyondLayers(boundary.faces[i].centre(boundary.points))
        )
        {
            ++n;
        }
    }

    return n;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar expectedFarCells
(
    const wallSurface& wall,
    const pointField& outerPoints,
    const farFieldDomain& domain,
    const farFieldControls& controls
)
{
    if (!controls.isWanted() || controls.type == farFieldType::mesh)
    {
        return domain.core.nCells;
    }

    const wallSurface triangles(trianglesOf(wall));
    const labelList across(columnsAcross(wall.faces, wall.border, wall.points));
    wallSurface outer(triangles);
    outer.points = outerPoints;
    const layerSizes fromLayers
    (
        sizesFromLayers
        (
            outer, makeWallAddressing(wall), wall.border, across, domain,
            controls
        )
    );
    const tetBoundary far
    (
        makeTetBoundary
        (
            wallWithoutLayers(wall), domain.boundary,
            std::cref(fromLayers.inSpace)
        )
    );
    const wallSurface both(joined(triangles, far));
    const farSpace space(both, triangles, outerPoints);
    if (across.size())
    {
        const label empty = emptySides(wall.border).first();
        return nTrianglesOn(wall.border.sides[empty].name, far.surface, space);
    }

    const std::unique_ptr<const cellSizes> fromBoth
    (
        hasOwnSizes(controls)
      ? sizesFromBoth(both, fromLayers.atPoints, far, domain, controls)
      : nullptr
    );

    const cellSizes& sizes = fromBoth ? *fromBoth : fromLayers.inSpace;
    const boundBox box(both.points, false);
    const scalar nCubes = nCubesIn(space, sizes, box);

    return cellsIn(controls.type, nCubes, wall.faces.size());
}

} // End namespace Foam

// ************************************************************************* //
