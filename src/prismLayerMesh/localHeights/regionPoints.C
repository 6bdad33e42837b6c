/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "regionPoints.H"
#include "searchableSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static boolList nearPoints
(
    const searchableSurface& surface,
    const scalar distance,
    const pointField& points
)
{
    List<pointIndexHit> hits;
    surface.findNearest
    (
        points, scalarField(points.size(), sqr(distance)), hits
    );

    boolList near(points.size());
    forAll(near, p)
    {
        near[p] = hits[p].hit();
    }

    return near;
}


static boolList insidePoints
(
    const layerRegion& region,
    const searchableSurface& surface,
    const pointField& points
)
{
    if (!surface.hasVolumeType())
    {
        FatalErrorInFunction
            << "The geometry of the region " << region.name << ", a "
            << surface.type() << ", is not closed: it has no inside, and only"
            << " mode distance" << exit(FatalError);
    }

    List<volumeType> types;
    surface.getVolumeType(points, types);

    boolList inside(points.size());
    forAll(inside, p)
    {
        inside[p] = types[p] == volumeType::INSIDE;
    }

    return inside;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::boolList Foam::regionPoints
(
    const layerRegion& region,
    const pointField& points,
    const Time& time
)
{
    const autoPtr<searchableSurface> surface
    (
        searchableSurface::New
        (
            region.geometry.get<word>("type"),
            IOobject
            (
                region.name,
                time.constant(),
                "triSurface",
                time,
                IOobject::MUST_READ,
                IOobject::NO_WRITE
            ),
            region.geometry
        )
    );

    if (region.mode == layerRegion::modes::distance)
    {
        return nearPoints(surface(), region.distance, points);
    }

    boolList in(insidePoints(region, surface(), points));

    if (region.mode == layerRegion::modes::outside)
    {
        for (bool& flag : in)
        {
            flag = !flag;
        }
    }

    return in;
}


// ************************************************************************* //
