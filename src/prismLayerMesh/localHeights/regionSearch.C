/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionSearch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

regionSearch::regionSearch(const geometryRegion& region, const Time& time)
:
    region_(region),
    surface_
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
    )
{
    if
    (
        region.mode != geometryRegion::modes::distance
     && !surface_->hasVolumeType()
    )
    {
        FatalErrorInFunction
            << "The geometry of the region " << region.name << ", a "
            << surface_->type() << ", is not closed: it has no inside, and only"
            << " mode distance" << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

boolList regionSearch::inside(const pointField& points) const
{
    List<volumeType> types;
    surface_->getVolumeType(points, types);

    boolList in(points.size());
    forAll(in, p)
    {
        in[p] = types[p] == volumeType::INSIDE;
    }

    return in;
}


scalarField regionSearch::distancesFromSurface(const pointField& points) const
{
    List<pointIndexHit> hits;
    surface_->findNearest(points, scalarField(points.size(), sqr(GREAT)), hits);

    scalarField distances(points.size());
    forAll(distances, p)
    {
        distances[p] = mag(hits[p].rawPoint() - points[p]);
    }

    return distances;
}


boolList regionSearch::contains(const pointField& points) const
{
    const bool near = region_.mode == geometryRegion::modes::distance;
    boolList in(near ? boolList(points.size()) : inside(points));

    if (near)
    {
        const scalarField distances(distancesFromSurface(points));

        forAll(in, p)
        {
            in[p] = distances[p] <= region_.distance;
        }
    }
    else if (region_.mode == geometryRegion::modes::outside)
    {
        for (bool& flag : in)
        {
            flag = !flag;
        }
    }

    return in;
}


scalarField regionSearch::distances(const pointField& points) const
{
    const boolList in(contains(points));
    scalarField distances(distancesFromSurface(points));
    forAll(distances, p)
    {
        distances[p] = in[p] ? 0 : distances[p] - region_.distance;
    }

    return distances;
}

} // End namespace Foam

// ************************************************************************* //
