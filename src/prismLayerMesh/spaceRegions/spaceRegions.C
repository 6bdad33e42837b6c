/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "spaceRegions.H"
#include "boundBox.H"
#include "cellPredicates.H"
#include "ListOps.H"
#include "ranges.H"
#include "readWallSurface.H"
#include "spaceParts.H"
#include "surfacePart.H"
#include "triangleIndex.H"
#include "unions.H"
#include "wallDefects.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Points are one if they are nearer than this share of the diagonal of the
//  bounding box
static constexpr scalar rounding = 1e-12;


//- Replaces the faces of a surface. Each gets the patch of a former face.
//  patchOf: labels of the former faces
static void setFaces
(
    const faceList& faces,
    const labelUList& patchOf,
    wallSurface& surface
)
{
    surface.faces = faces;
    surface.patchIDs = labelList(surface.patchIDs, patchOf);
}


//- Merges points whose distance is rounding, and keeps one of triangles on the
//  same points, and only triangles with area
static void mergeRounded(wallSurface& surface)
{
    wallReading untold;
    mergeNearPoints(surface, rounding, untold);

    triangleIndex known(2*surface.faces.size());
    bitSet isKept(surface.faces.size());
    forAll(surface.faces, i)
    {
        const face& f = surface.faces[i];
        const pointField& x = surface.points;
        isKept.set
        (
            i,
            !isCollinear(x[f[0]], x[f[1]], x[f[2]])
         && known.insert(triFace(f), i)
        );
    }
    keepFaces(isKept, surface);
}


//- Refuses a region whose point is in a part of space of another one, or
//  outside
static void refuseLeak
(
    const wallSurface& surface,
    const regionSeed& seed,
    const string& other,
    const point& to
)
{
    const leakPath leak(findLeak(surface, seed.inside, to));

    FatalErrorInFunction
        << "The region " << seed.name << " leaks into " << other.c_str()
        << ": there is an opening " << leak.width << " m wide at "
        << leak.narrowest << nl << "A path through it:";
    for (const point& x : leak.places)
    {
        FatalError << nl << "    " << x;
    }
    FatalError
        << nl << "Close the opening, or move the point inside of the region"
        << exit(FatalError);
}


//- Returns the region of each part of space, -1 if there is none
static labelList findRegionsOfParts
(
    const wallSurface& surface,
    const UList<regionSeed>& seeds,
    const spaceParts& parts
)
{
    labelList regionOf(parts.nParts(), -1);
    forAll(seeds, i)
    {
        const label parti = parts.partAt(seeds[i].inside);
        const label other = regionOf[parti];
        if (parti == 0)
        {
            const boundBox box(surface.points, false);
            refuseLeak
            (
                surface, seeds[i], "the outside",
                box.max() + 0.5*box.span() + vector::uniform(0.01*box.mag())
            );
        }
        if (other >= 0)
        {
            refuseLeak
            (
                surface, seeds[i], "the region " + seeds[other].name,
                seeds[other].inside
            );
        }
        regionOf[parti] = i;
    }

    return regionOf;
}


//- Refuses sheets, and a boundary that touches itself
static void requireSound(const wallSurface& whole, const spaceRegion& region)
{
    labelList sorted(region.faces);
    Foam::sort(sorted);
    for (label i = 1; i < sorted.size(); ++i)
    {
        if (sorted[i] == sorted[i - 1])
        {
            FatalErrorInFunction
                << "A sheet of the patch "
                << whole.patchNames[whole.patchIDs[sorted[i]]]
                << " is within the region " << region.name
                << ", on both sides of it, at "
                << whole.faces[sorted[i]].centre(whole.points) << nl
                << "A region is bounded by surfaces with other regions, or"
                << " nothing, on their other side" << exit(FatalError);
        }
    }

    const List<wallDefect> defects(findWallDefects(region.surface));
    if (defects.size())
    {
        FatalErrorInFunction
            << "The boundary of the region " << region.name
            << " cannot be meshed" << nl << describe(defects).c_str()
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

label spaceRegions::beyond(const label regioni, const label facei) const
{
    const labelPair& both = regionsOfFace[regions[regioni].faces[facei]];

    return both.first() == regioni ? both.second() : both.first();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallSurface makeArrangement(const wallSurface& surface)
{
    wallSurface result(surface);
    labelList faceOf;
    setFaces(wallTriangles(surface, faceOf), faceOf, result);
    mergeRounded(result);

    const dividedSurface divided(divideAtIntersections(result));
    result.points = divided.points;
    setFaces(divided.faces, divided.triangleOf, result);
    mergeRounded(result);

    return result;
}


spaceRegions makeSpaceRegions
(
    const wallSurface& arrangement,
    const UList<regionSeed>& seeds
)
{
    spaceRegions result;
    result.surface = arrangement;
    const spaceParts parts(result.surface);
    const labelList regionOf
    (
        findRegionsOfParts(result.surface, seeds, parts)
    );

    result.regionsOfFace.setSize(result.surface.faces.size());
    forAll(result.regionsOfFace, i)
    {
        result.regionsOfFace[i] = labelPair
        (
            regionOf[parts.inFront(i)], regionOf[parts.behind(i)]
        );
    }

    result.regions.setSize(seeds.size());
    forAll(regionOf, parti)
    {
        if (regionOf[parti] >= 0)
        {
            spaceRegion& region = result.regions[regionOf[parti]];
            region.name = seeds[regionOf[parti]].name;
            region.surface =
                parts.boundaryOf(parti, region.points, region.faces);
            region.volume = parts.volumeOf(parti);
            requireSound(result.surface, region);
        }
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
