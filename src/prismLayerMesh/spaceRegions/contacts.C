/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contacts.H"
#include "boundBox.H"
#include "EdgeMap.H"
#include "equalPoints.H"
#include "HashSet.H"
#include "ListOps.H"
#include "Map.H"
#include "triangleIndex.H"
#include "wallDefects.H"
#include "wallPredicates.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef HashSet<edge, Hash<edge>> edgeSet;


//- Sets points and edges of faces between two regions
static void findInterfaces
(
    const spaceRegions& all,
    bitSet& points,
    edgeSet& edges
)
{
    points.resize(all.surface.points.size());
    forAll(all.surface.faces, facei)
    {
        const labelPair& both = all.regionsOfFace[facei];
        const label a = both.first();
        const label b = both.second();
        if (a >= 0 && b >= 0 && a != b)
        {
            const face& f = all.surface.faces[facei];
            points.set(f);
            forAll(f, k)
            {
                edges.insert(f.faceEdge(k));
            }
        }
    }
}


//- Returns the faces of a region. Points of one place are one if another region
//  is there.
static faceList facesWithShared
(
    const spaceRegion& region,
    const bitSet& isShared
)
{
    labelList oneOf(identity(region.points.size()));
    Map<label> known;
    forAll(oneOf, p)
    {
        if (isShared.test(region.points[p]))
        {
            known.insert(region.points[p], p);
            oneOf[p] = known[region.points[p]];
        }
    }
    faceList faces(region.surface.faces);
    for (face& f : faces)
    {
        inplaceRenumber(oneOf, f);
    }

    return faces;
}


//- Divides edges of a surface that have no triangle in common, and takes them
//  out of the list. 'middles' has a point for each divided edge.
static void divideApart
(
    EdgeMap<label>& edges,
    pointField& middles,
    wallSurface& surface
)
{
    const wallSides sides(makeWallSides(surface));
    bitSet isTouched(surface.faces.size());
    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> on(sides.on(e));
        const edge whole(on[0].low, on[0].high);
        bool isFree = edges.found(whole);
        for (const wallSide& s : on)
        {
            isFree = isFree && !isTouched.test(s.facei);
        }
        if (!isFree)
        {
            continue;
        }

        const label p = surface.points.size() + middles.size();
        middles.append(whole.centre(surface.points));
        edges.erase(whole);
        for (const wallSide& s : on)
        {
            const face f(surface.faces[s.facei]);
            const edge along(s.along());
            const label c = f.nextLabel(f.find(along.end()));
            surface.faces[s.facei] = face({along.start(), p, c});
            surface.faces.append(face({p, along.end(), c}));
            surface.patchIDs.append(label(surface.patchIDs[s.facei]));
            isTouched.set(s.facei);
        }
    }
}


//- Returns the angle [rad] of a triangle at one of its points
static scalar angleAt(const pointField& x, const face& f, const label k)
{
    const vector a(x[f.nextLabel(k)] - x[f[k]]);
    const vector b(x[f.prevLabel(k)] - x[f[k]]);

    return Foam::atan2(mag(a ^ b), a & b);
}


//- Returns the part of a vector that is normal to all of some unit vectors
static vector normalTo(const UList<vector>& normals, vector v)
{
    // Planes that are parallel but for rounding are one
    static constexpr scalar smallest = 1e-6;
    DynamicList<vector> axes;
    for (vector n : normals)
    {
        for (const vector& axis : axes)
        {
            n -= (n & axis)*axis;
        }
        if (mag(n) > smallest)
        {
            axes.append(n/mag(n));
            v -= (v & axes.last())*axes.last();
        }
    }

    return v;
}


//- Refuses contacts that have moved into each other: with the region all around
//  them there is no room for layers between
static void refuseContact(const spaceRegion& region, const bitSet& isContact)
{
    const wallSurface& surface = region.surface;
    for (const labelPair& both : findIntersectingFaces(surface, bitSet()))
    {
        for (const label p : surface.faces[both.first()])
        {
            if (isContact.test(p))
            {
                FatalErrorInFunction
                    << "The boundary of the region " << region.name
                    << " touches itself in a point alone, at "
                    << surface.points[p] << nl
                    << "Move the bodies apart there, or into each other"
                    << exit(FatalError);
            }
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool divideBetweenFreeEdges(const spaceRegions& all, wallSurface& surface)
{
    bitSet isShared;
    edgeSet sharedEdges;
    findInterfaces(all, isShared, sharedEdges);

    EdgeMap<label> edges;
    for (const spaceRegion& region : all.regions)
    {
        const auto divide = [&](const edge& e)
        {
            const edge whole(region.points[e.start()], region.points[e.end()]);
            if (!sharedEdges.found(whole))
            {
                edges.insert(whole, 0);
            }
        };

        const faceList faces(facesWithShared(region, isShared));
        const label nPoints = region.points.size();
        const wallSides sides(makeWallSides(faces, nPoints));
        for (label e = 0; e < sides.nEdges(); ++e)
        {
            if (sides.on(e).size() > 2)
            {
                divide(sides.on(e)[0].along());
            }
        }
        triangleIndex triangles(2*faces.size());
        for (const face& f : faces)
        {
            if (!triangles.insert(triFace(f), 0))
            {
                divide(f.faceEdge(f.longestEdge(region.surface.points)));
            }
        }
    }

    const bool isDivided = edges.size();
    while (edges.size())
    {
        pointField middles;
        divideApart(edges, middles, surface);
        surface.points.append(middles);
    }

    return isDivided;
}


bitSet contactsOf(const spaceRegion& region, const label nPoints)
{
    labelList nCopies(nPoints, Zero);
    for (const label p : region.points)
    {
        ++nCopies[p];
    }
    bitSet isContact(region.points.size());
    forAll(region.points, p)
    {
        isContact.set(p, nCopies[region.points[p]] > 1);
    }

    return isContact;
}


vectorField contactDirections
(
    const spaceRegion& region,
    const bitSet& contacts,
    const boolList& isSide
)
{
    const wallSurface& surface = region.surface;
    vectorField directions(surface.points.size(), Zero);
    List<DynamicList<vector>> sideNormals(surface.points.size());
    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        const vector n(f.unitNormal(surface.points));
        forAll(f, k)
        {
            if (contacts.test(f[k]) && isSide[surface.patchIDs[facei]])
            {
                sideNormals[f[k]].append(n);
            }
            else if (contacts.test(f[k]))
            {
                directions[f[k]] += angleAt(surface.points, f, k)*n;
            }
        }
    }

    // Normals that cancel each other have no sum
    static constexpr scalar smallest = 1e-3;
    for (const label p : contacts)
    {
        vector& d = directions[p];
        d = normalTo(sideNormals[p], d);
        d = mag(d) < smallest ? vector(Zero) : d/mag(d);
    }

    return directions;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void spaceRegions::open
(
    const label regioni,
    const std::function<bool(const word&)>& isSide,
    const scalar share
)
{
    spaceRegion& region = regions[regioni];
    boolList isSidePatch(region.surface.patchNames.size());
    forAll(isSidePatch, patchi)
    {
        isSidePatch[patchi] = isSide(region.surface.patchNames[patchi]);
    }
    forAll(region.faces, facei)
    {
        const label patchi = region.surface.patchIDs[facei];
        if (isSidePatch[patchi] && isSheet(region.faces[facei]))
        {
            FatalErrorInFunction
                << "The sheet " << region.surface.patchNames[patchi]
                << " is to have no layers, and the region " << region.name
                << " has layers" << nl << "Remove nSurfaceLayers 0 of the"
                << " sheet, or write layers no; for the region"
                << exit(FatalError);
        }
    }

    const bitSet isContact(contactsOf(region, surface.points.size()));
    region.openings =
        (share*boundBox(surface.points, false).mag())
       *contactDirections(region, isContact, isSidePatch);
    region.surface.points += region.openings;
    const List<wallDefect> defects(findWallDefects(region.surface));
    if (defects.size())
    {
        refuseContact(region, isContact);
        FatalErrorInFunction
            << "The boundary of the region " << region.name
            << " cannot be meshed" << nl << describe(defects).c_str()
            << exit(FatalError);
    }
}


bitSet spaceRegions::close(const label regioni, pointField& points)
{
    spaceRegion& region = regions[regioni];
    equalPoints opened;
    forAll(region.openings, p)
    {
        if (magSqr(region.openings[p]) > 0)
        {
            opened.insert(region.surface.points[p], region.points[p]);
            region.surface.points[p] = surface.points[region.points[p]];
        }
    }

    bitSet isMoved(points.size());
    forAll(points, i)
    {
        const label p = opened.find(points[i]);
        if (p >= 0)
        {
            points[i] = surface.points[p];
            isMoved.set(i);
        }
    }

    return isMoved;
}

} // End namespace Foam

// ************************************************************************* //
