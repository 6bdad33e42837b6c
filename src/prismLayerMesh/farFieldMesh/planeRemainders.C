/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatchRemainders.H"
#include "sideRegions.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farFieldBoundary makePlaneRemainders
(
    const prismLayers& layers,
    const coreCut& cut,
    const std::function<scalar(const point&)>& size
)
{
    boundBox box(layers.points, false);
    box.inflate(1);
    sideRegions on(layers, size, 1e-9*box.mag());

    const label first = on.points().size();
    on.points().append(cut.surface.points);
    forAll(on.sides, s)
    {
        // Faces that are gone are to the left seen from outside
        for (const edge& e : cut.borders[s])
        {
            const edge reversed(e.end() + first, e.start() + first);
            on.regions[s].boundary.append(reversed);
        }
        for (const edge& e : cut.limits[s])
        {
            on.regions[s].limits.append(edge(e[0] + first, e[1] + first));
        }
    }
    on.triangulate();

    return on.made;
}

} // End namespace Foam

// ************************************************************************* //
