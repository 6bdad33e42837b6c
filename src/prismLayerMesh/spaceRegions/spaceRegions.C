/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "spaceRegions.H"
#include "boundBox.H"
#include "cellPredicates.H"
#include "contacts.H"
#include "EdgeMap.H"
#include "equalPoints.H"
#include "ListOps.H"
#include "OStringStream.H"
#include "ranges.H"
#include "readWallSurface.H"
#include "spaceParts.H"
#include "stageProgress.H"
#include "surfacePart.H"
#include "throwingErrors.H"
#include "triangleIndex.H"
#include "unions.H"
#include "wallChanges.H"
#include "wallDefects.H"
#include "wallPredicates.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


//- Merges points that are nearer to each other than a share of the diagonal of
//  the surface's box, and keeps one of triangles on the same points
static void mergePoints(const scalar share, wallSurface& surface)
{
    wallReading untold;
    mergeNearPoints(surface, share, untold);

    triangleIndex known(2*surface.faces.size());
    bitSet isKept(surface.faces.size());
    forAll(surface.faces, i)
    {
        isKept.set(i, known.insert(triFace(surface.faces[i]), i));
    }
    keepFaces(isKept, surface);
}


//- Removes the triangles whose area is zero, exactly. Their neighbours are no
//  longer joined by edges.
static void removeWithoutArea(wallSurface& surface)
{
    bitSet isKept(surface.faces.size());
    forAll(surface.faces, i)
    {
        const face& f = surface.faces[i];
        const pointField& x = surface.points;
        isKept.set(i, !isCollinear(x[f[0]], x[f[1]], x[f[2]]));
    }
    keepFaces(isKept, surface);
}


//- Divides the longest edges of triangles at their third points, if these are
//  nearer to the edges than a tolerance [m]; the triangles go. Divides an edge
//  once. Returns the number of triangles that are gone.
static label divideAtLowPoints(const scalar tolerance, wallSurface& surface)
{
    const pointField& x = surface.points;
    EdgeMap<label> pointsOn;
    bitSet isTouched(x.size());
    bitSet isKept(surface.faces.size(), true);
    forAll(surface.faces, i)
    {
        const face& f = surface.faces[i];
        const label k = f.longestEdge(x);
        const bool isFree = allOf(f, [&](const label p)
        {
            return !isTouched.test(p);
        });
        if (isFree && smallestHeight(x, f) < tolerance)
        {
            pointsOn.insert(f.faceEdge(k), f.prevLabel(k));
            isKept.unset(i);
            isTouched.set(f);
        }
    }

    DynamicList<face> faces(surface.faces.size());
    DynamicList<label> faceOf(surface.faces.size());
    for (const label i : isKept)
    {
        const face& f = surface.faces[i];
        label k = 0;
        while (k < 3 && !pointsOn.found(f.faceEdge(k)))
        {
            ++k;
        }
        if (k == 3)
        {
            faces.append(f);
            faceOf.append(i);
            continue;
        }
        const label p = pointsOn[f.faceEdge(k)];
        const label a = f[k];
        const label b = f.nextLabel(k);
        const label c = f.prevLabel(k);
        faces.append(face({a, p, c}));
        faces.append(face({p, b, c}));
        faceOf.append(labelList(2, i));
    }
    const label nGone = isKept.size() - isKept.count();
    setFaces(faces, faceOf, surface);

    return nGone;
}


//- Makes the ends of the shortest edges of triangles one, if the triangles are
//  lower than a tolerance [m]. Returns the number of these edges.
static label collapseLowTriangles(const scalar tolerance, wallSurface& surface)
{
    const pointField& x = surface.points;
    labelList oneOf(identity(x.size()));
    bitSet isTouched(x.size());
    label nCollapsed = 0;
    for (const face& f : surface.faces)
    {
        const bool isFree = allOf(f, [&](const label p)
        {
            return !isTouched.test(p);
        });
        if (isFree && smallestHeight(x, f) < tolerance)
        {
            label shortest = 0;
            for (label k = 1; k < 3; ++k)
            {
                if (f.faceEdge(k).mag(x) < f.faceEdge(shortest).mag(x))
                {
                    shortest = k;
                }
            }
            const edge e(f.faceEdge(shortest));
            oneOf[max(e.start(), e.end())] = min(e.start(), e.end());
            isTouched.set(f);
            ++nCollapsed;
        }
    }

    bitSet isKept(surface.faces.size());
    forAll(surface.faces, i)
    {
        inplaceRenumber(oneOf, surface.faces[i]);
        isKept.set(i, !hasRepeatedPoint(surface.faces[i]));
    }
    keepFaces(isKept, surface);

    return nCollapsed;
}


//- Triangles are divided so many times at most: their rounded parts may
//  intersect again
static constexpr label maxDivisions = 5;

//- Low triangles are removed so many times at most
static constexpr label maxPasses = 30;

//- One in so many times their shortest edges are collapsed, not their longest
//  ones divided
static constexpr label collapsingPass = 10;


//- Merges near points, and removes triangles that are lower than the tolerance
static void removeLowTriangles(const scalar share, wallSurface& surface)
{
    const scalar tolerance = share*boundBox(surface.points, false).mag();
    label nPasses = 0;
    repeatUntilStable("removing low triangles", maxPasses, [&]()
    {
        mergePoints(share, surface);

        // Low triangles on one short edge divide each other again and again
        return
            ++nPasses % collapsingPass
          ? divideAtLowPoints(tolerance, surface) > 0
          : collapseLowTriangles(tolerance, surface) > 0;
    });
    mergePoints(share, surface);
    removeWithoutArea(surface);
}


static string textOf(const leakPath& leak)
{
    OStringStream os;
    os  << ": there is an opening " << leak.width << " m wide at "
        << leak.narrowest << nl << "A path through it:";
    for (const point& x : leak.places)
    {
        os  << nl << "    " << x;
    }

    return os.str();
}


//- Returns the parts of triangles without flaps: parts that cover others, and
//  have an edge that no other part has. A surface that is folded has them.
static bitSet withoutFlaps(const dividedSurface& divided)
{
    bitSet isKept(divided.faces.size(), true);
    const wallSides sides
    (
        makeWallSides(divided.faces, divided.points.size())
    );
    bool isChanged = true;
    while (isChanged)
    {
        isChanged = false;
        for (label e = 0; e < sides.nEdges(); ++e)
        {
            label n = 0;
            label last = -1;
            for (const wallSide& s : sides.on(e))
            {
                n += isKept.test(s.facei);
                last = isKept.test(s.facei) ? s.facei : last;
            }
            if (n == 1 && divided.covers[last])
            {
                isKept.unset(last);
                isChanged = true;
            }
        }
    }

    return isKept;
}


//- Divides the triangles of a surface where they meet, and removes slivers.
//  Returns the triangles that intersect still: rounding has moved them.
static List<labelPair> divide(const scalar tolerance, wallSurface& surface)
{
    // Neighbours of triangles without area are joined by the division again
    removeWithoutArea(surface);
    const dividedSurface divided(divideAtIntersections(surface));
    surface.points = divided.points;
    setFaces(divided.faces, divided.triangleOf, surface);
    keepFaces(withoutFlaps(divided), surface);
    removeLowTriangles(tolerance, surface);

    return findIntersectingFaces(surface, bitSet());
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
    string path;
    try
    {
        const throwingErrors throwing;
        path = textOf(findLeak(surface, seed.inside, to));
    }
    catch (const Foam::error&)
    {
        // Rounded triangles may intersect: there is no path then
    }
    FatalErrorInFunction
        << "The region " << seed.name << " leaks into " << other.c_str()
        << path.c_str() << nl
        << "Close the opening, or move the point inside of the region"
        << exit(FatalError);
}


//- Gives parts of space without a region that are thin, as they are between
//  solids that touch each other but for rounding, to the region that has the
//  most area on them.
//  thickness: a part is thin if its volume is less than half of its area times
//  the thickness [m]
static void giveThinParts
(
    const wallSurface& surface,
    const spaceParts& parts,
    const scalar thickness,
    labelList& regionOf
)
{
    scalarField areas(parts.nParts(), Zero);
    List<Map<scalar>> areaOn(parts.nParts());
    forAll(surface.faces, i)
    {
        const scalar area = surface.faces[i].mag(surface.points);
        const label front = parts.inFront(i);
        const label back = parts.behind(i);
        areas[front] += area;
        areas[back] += area;
        if (regionOf[back] >= 0)
        {
            areaOn[front](regionOf[back], 0) += area;
        }
        if (regionOf[front] >= 0)
        {
            areaOn[back](regionOf[front], 0) += area;
        }
    }

    const labelList given(regionOf);
    for (label parti = 1; parti < parts.nParts(); ++parti)
    {
        if
        (
            given[parti] < 0 && areaOn[parti].size()
         && parts.volumeOf(parti) < 0.5*thickness*areas[parti]
        )
        {
            label best = -1;
            for (const label r : areaOn[parti].sortedToc())
            {
                best =
                    best < 0 || areaOn[parti][r] > areaOn[parti][best]
                  ? r : best;
            }
            regionOf[parti] = best;
        }
    }
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


//- Returns a surface without the faces between a region and the thin parts of
//  space that become a part of it
static wallSurface withoutInnerFaces
(
    const wallSurface& surface,
    const UList<regionSeed>& seeds,
    const scalar tolerance
)
{
    const spaceParts parts(surface);
    const labelList given(findRegionsOfParts(surface, seeds, parts));
    labelList regionOf(given);
    giveThinParts
    (
        surface, parts, tolerance*boundBox(surface.points, false).mag(),
        regionOf
    );

    bitSet isKept(surface.faces.size(), true);
    forAll(surface.faces, i)
    {
        const label front = parts.inFront(i);
        const label back = parts.behind(i);
        if
        (
            regionOf[front] >= 0 && regionOf[front] == regionOf[back]
         && given[front] != given[back]
        )
        {
            isKept.unset(i);
        }
    }
    wallSurface result(surface);
    keepFaces(isKept, result);

    return result;
}


//- Refuses sheets that are no baffles
static void requireBaffles
(
    const spaceRegions& all,
    const label regioni,
    const wordRes& baffles
)
{
    for (const label facei : all.regions[regioni].faces)
    {
        const word& patch =
            all.surface.patchNames[all.surface.patchIDs[facei]];
        if (all.isSheet(facei) && !baffles.match(patch))
        {
            FatalErrorInFunction
                << "A sheet of the patch " << patch << " is within the region "
                << all.regions[regioni].name << ", on both sides of it, at "
                << all.surface.faces[facei].centre(all.surface.points) << nl
                << "Name the patch in surface.baffles if both sides of it are"
                << " to be walls" << exit(FatalError);
        }
    }
}


//- Makes the regions of a surface without any change of the surface
static spaceRegions makeRegionsOn
(
    const wallSurface& surface,
    const UList<regionSeed>& seeds
)
{
    spaceRegions result;
    result.surface = surface;
    const spaceParts parts(surface);
    const labelList regionOf(findRegionsOfParts(surface, seeds, parts));

    result.regionsOfFace.setSize(surface.faces.size());
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
        }
    }

    return result;
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

bool spaceRegions::isSheet(const label facei) const
{
    const labelPair& both = regionsOfFace[facei];

    return both.first() >= 0 && both.first() == both.second();
}


label spaceRegions::beyond(const label regioni, const label facei) const
{
    const label f = regions[regioni].faces[facei];
    const labelPair& both = regionsOfFace[f];

    return
        isSheet(f) ? -1
      : both.first() == regioni ? both.second() : both.first();
}


void spaceRegions::settle(const label regioni, pointField& points)
{
    const pointField given(regions[regioni].surface.points);
    const labelList labels(regions[regioni].points);
    const vectorField& openings = regions[regioni].openings;
    equalPoints known;
    forAll(given, p)
    {
        known.insert(given[p], p);
    }

    labelList isMoved(surface.points.size(), Zero);
    isSettled.resize(surface.points.size());
    for (point& x : points)
    {
        const label same = known.find(x);
        const label p =
            same >= 0 ? same : findMin(scalarField(magSqr(given - x)));
        if (isSettled.set(labels[p]) && same < 0)
        {
            isMoved[labels[p]] = 1;
            surface.points[labels[p]] = x - openings[p];
        }
        x = surface.points[labels[p]] + openings[p];
    }

    for (spaceRegion& region : regions)
    {
        forAll(region.points, p)
        {
            if (isMoved[region.points[p]])
            {
                region.surface.points[p] =
                    surface.points[region.points[p]] + region.openings[p];
            }
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallSurface makeArrangement
(
    const wallSurface& surface,
    const scalar tolerance
)
{
    wallSurface result(surface);
    labelList faceOf;
    setFaces(wallTriangles(surface, faceOf), faceOf, result);
    mergePoints(tolerance, result);
    List<labelPair> pairs;
    repeatUntilStable("dividing triangles where they meet", maxDivisions, [&]()
    {
        pairs = divide(tolerance, result);

        return pairs.size() > 0;
    });
    if (pairs.size())
    {
        FatalErrorInFunction
            << "Two parts of the surface are nearly, and not quite, the same:"
            << " after rounding " << pairs.size() << " pairs of triangles"
            << " intersect, first at "
            << result.faces[pairs[0].first()].centre(result.points) << nl
            << "Give them the same triangles there, or move them apart"
            << exit(FatalError);
    }

    return result;
}


spaceRegions makeSpaceRegions
(
    const wallSurface& arrangement,
    const UList<regionSeed>& seeds,
    const wordRes& baffles,
    const scalar tolerance
)
{
    wallSurface surface(withoutInnerFaces(arrangement, seeds, tolerance));
    spaceRegions result;
    do
    {
        result = makeRegionsOn(surface, seeds);
    }
    while (divideBetweenFreeEdges(result, surface));

    forAll(result.regions, r)
    {
        spaceRegion& region = result.regions[r];
        region.openings.setSize(region.points.size(), Zero);
        requireBaffles(result, r, baffles);
    }

    return result;
}


List<unusedArea> unusedAreas(const spaceRegions& all)
{
    const wallSurface& surface = all.surface;
    List<unusedArea> areas(surface.patchNames.size());
    scalarField largest(areas.size(), Zero);
    forAll(surface.faces, facei)
    {
        const label patchi = surface.patchIDs[facei];
        const scalar area = surface.faces[facei].mag(surface.points);
        const labelPair& regions = all.regionsOfFace[facei];
        unusedArea& ofPatch = areas[patchi];
        ofPatch.whole += area;
        if (regions.first() < 0 && regions.second() < 0)
        {
            ofPatch.unused += area;
            if (area > largest[patchi])
            {
                largest[patchi] = area;
                ofPatch.place = surface.faces[facei].centre(surface.points);
            }
        }
    }

    return areas;
}

} // End namespace Foam

// ************************************************************************* //
