/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideRegions.H"
#include "planePoints.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sideRegions::sideRegions
(
    const prismLayers& layers,
    const std::function<scalar(const point&)>& size,
    const scalar tolerance,
    const wordList& patchNames,
    const wordList& patchTypes
)
:
    sides(layers.border.sides),
    size(size),
    tolerance(tolerance),
    border(layers, tolerance),
    regions(sides.size())
{
    made.surface.patchNames = patchNames;
    made.surface.patchTypes = patchTypes;
    made.firstSide = patchNames.size();
    for (const sidePatch& side : sides)
    {
        made.surface.patchNames.append(side.name);
        made.surface.patchTypes.append(side.type);
    }

    made.columns = border.columns();
    points() = border.outerPoints();
    forAll(border.outerEdges(), i)
    {
        regions[layers.border.edgeSides[i]].boundary.append
        (
            border.outerEdges()[i]
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void sideRegions::triangulate()
{
    forAll(sides, s)
    {
        planeRegion& region = regions[s];
        region.limits = dividedEdges
        (
            points(), region.limits, border.outerPointsOn(s), tolerance
        );
        region.normal = -sides[s].normal;
        region.isCurved = sides[s].isCurved();
        const pointField inside
        (
            planePoints(points(), region, sides[s], size)
        );
        region.points = identity(inside.size(), points().size());
        points().append(inside);

        for (const face& f : triangulatePlane(points(), region))
        {
            addTriangle(f, made.firstSide + s);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
