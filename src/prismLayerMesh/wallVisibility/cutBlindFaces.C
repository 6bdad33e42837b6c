/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutBlindFaces.H"
#include "cutReflexFaces.H"
#include "ranges.H"
#include "wallVisibility.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The polygons at points
static boolList polygonsAt(const wallSurface& wall, const labelUList& points)
{
    boolList isAsked(wall.points.size(), false);
    UIndirectList<bool>(isAsked, points) = true;
    boolList result(wall.faces.size());

    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];
        result[facei] = f.size() > 3 && std::any_of
        (
            f.begin(), f.end(), [&](const label p) { return isAsked[p]; }
        );
    }

    return result;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

label cutBlindFaces(wallSurface& wall)
{
    const bool hasPolygons =
        anyOf(wall.faces, [](const face& f) { return f.size() > 3; });
    const labelList blind
    (
        hasPolygons ? pointsWithEmptyCones(wall) : labelList()
    );
    if (blind.empty())
    {
        return 0;
    }

    wallSurface trial(wall);
    cutFaces(trial, polygonsAt(wall, blind));
    const labelList stillBlind(pointsWithEmptyCones(trial));
    labelList cured(blind);
    inplaceSubsetList
    (
        cured, [&](const label p) { return !stillBlind.found(p); }
    );

    return cutFaces(wall, polygonsAt(wall, cured));
}

} // End namespace Foam

// ************************************************************************* //
